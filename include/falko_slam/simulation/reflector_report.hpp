// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "falko_slam/simulation/laser_scanner.hpp"

namespace falko_slam {

/// A reflector as the device's own detection reports it; which one it is nobody knows.
struct ReflectorDetection {
  double range = 0.0;    ///< to its axis [m]
  double bearing = 0.0;  ///< [rad], in [-pi, pi)
  std::size_t first_beam = 0;
  std::size_t last_beam = 0;  ///< less than the first one across the seam of the scan
  std::size_t hits = 0;       ///< beams
  double mean_intensity = 0.0;
  double time_offset = 0.0;  ///< of its middle beam after the first beam of the scan [s]
};

/// Beams side by side that are brighter than any matt surface at their range can be, and of nearly
/// the same range. Bearing: their mean, weighted by the power received; range: their mean and what
/// lies between the front of a cylinder of this diameter [m] and its axis. Nothing is corrected for
/// motion. Empty if the scanner has no intensities.
std::vector<ReflectorDetection> report_reflectors(const LaserModel& laser,
                                                  const SimulatedScan& scan, double diameter);

}  // namespace falko_slam
