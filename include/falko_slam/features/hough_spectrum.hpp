// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct HoughSpectrumParams {
  int angles = 90;           ///< resolution of the spectrum: cells over [0, pi); even. [8, 720]
  double offset_cell = 0.1;  ///< of the lines' distance from the sensor [m]
  double max_range = 20.0;   ///< points farther away do not take part [m]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const HoughSpectrumParams& params);

/// The direction of the walls around the sensor, where most of them are parallel or orthogonal.
///
/// The Hough spectrum \cite censi2005hsm, HS(theta) = sum over rho of HT(theta, rho)^2, has peaks
/// in the directions of long walls. Spectrum plus spectrum turned by 90 degrees gives the cell of
/// the dominant pair of directions. From there the directions of the walls themselves, measured
/// between points 0.3 m apart, are averaged with a weight that falls off on either side until the
/// mean stands still. What it converges to does not depend on the cells.
///
/// Keeps its memory between scans; not thread-safe.
class HoughSpectrum {
 public:
  explicit HoughSpectrum(const HoughSpectrumParams& params = {});
  ~HoughSpectrum();
  HoughSpectrum(HoughSpectrum&&) noexcept;
  HoughSpectrum& operator=(HoughSpectrum&&) noexcept;

  /// In [0, pi/2), laser frame; the other direction is orthogonal to it. Empty without a wall in
  /// sight.
  std::optional<double> dominant_direction(const LaserScan& scan);

  /// HS over [0, pi) of the scan last asked about; theta is the direction of the lines' normal.
  const std::vector<double>& spectrum() const { return spectrum_; }

 private:
  struct Workspace;
  HoughSpectrumParams params_;
  std::unique_ptr<Workspace> workspace_;
  std::vector<double> spectrum_;
};

}  // namespace falko_slam
