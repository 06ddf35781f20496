// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "falko_slam/sensor/deskew.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace test {

constexpr Duration kRevolution = std::chrono::milliseconds(125);  // NAV350: 8 Hz

/// A laser that takes `kRevolution` for its beams, counter-clockwise unless `clockwise`.
struct MovingLaser {
  SimulatedLaserParams laser;
  bool clockwise = false;
  Time stamp{std::chrono::seconds(7)};

  /// From the pose at the stamp (and of the first beam) on, so far until the next scan begins.
  LaserScan scan(const Scene& scene, const Pose2& world_T_laser, const Pose2& way,
                 std::mt19937_64& random) const {
    SimulatedLaserParams turning = laser;
    if (clockwise) {
      turning.angle_min = -laser.angle_min - laser.angle_increment;
      turning.angle_increment = -laser.angle_increment;
    }
    const auto ranges = simulate_moving_ranges(scene, world_T_laser, way, turning, random);
    RawScan raw;
    raw.stamp = stamp;
    raw.angle_min = turning.angle_min;
    raw.angle_increment = turning.angle_increment;
    raw.time_increment = to_seconds(kRevolution) / static_cast<double>(laser.beams);
    raw.range_max = laser.range_max;
    raw.ranges = ranges.data();
    raw.range_count = ranges.size();
    LaserScan result;
    normalize(raw, {}, result);
    return result;
  }
};

inline MovingLaser moving_laser(std::size_t beams, double noise) {
  MovingLaser result;
  result.laser.beams = beams;
  result.laser.angle_increment = kTwoPi / static_cast<double>(beams);
  result.laser.noise = noise;
  return result;
}

/// Ranges where both scans are valid: differences, by size.
inline std::vector<double> range_differences(const LaserScan& a, const LaserScan& b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.valid(i) && b.valid(i)) result.push_back(std::abs(a.ranges[i] - b.ranges[i]));
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace test
}  // namespace falko_slam
