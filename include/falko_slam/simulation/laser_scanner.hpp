// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <random>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/simulation/laser_model.hpp"
#include "falko_slam/simulation/motion_track.hpp"
#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// A revolution as the scanner measured it.
struct SimulatedScan {
  Time first_beam{};
  std::vector<float> ranges;       ///< [m]; 0: no echo, or one that is too near or too far
  std::vector<float> intensities;  ///< empty if the scanner has none
};

/// As the driver of the scanner publishes it: angle_max is one increment past the last beam, no
/// echo is 0, the stamp is that of the first beam. Borrows the arrays.
RawScan as_raw_scan(const LaserModel& laser, const SimulatedScan& scan);

/// A scanner on a vehicle: each beam leaves from where the vehicle is at that instant, things that
/// move stand where they are at that instant.
class LaserScanner {
 public:
  /// The world must outlive it; `world_begin` is when its movements begin. Throws
  /// std::invalid_argument for a model that is none.
  LaserScanner(const LaserModel& laser, const Pose2& base_T_laser, const World& world,
               Time world_begin);
  ~LaserScanner();
  LaserScanner(LaserScanner&&) noexcept;
  LaserScanner& operator=(LaserScanner&&) noexcept;

  /// `track` is that of base_link; it must reach from the first beam to the last. The result is
  /// good until the next call.
  const SimulatedScan& scan(Time first_beam, const MotionTrack& track, std::mt19937_64& random);

  const LaserModel& laser() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The cylinders of the world that are reflectors, as they stand at the beginning.
std::vector<Cylinder> reflectors_of(const World& world);

/// What the device is told of them [m]: that of the first one, 0.08 if there is none.
double diameter_of_reflectors(const World& world);

}  // namespace falko_slam
