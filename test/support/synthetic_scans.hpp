// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "falko_slam/sensor/scan_normalizer.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace test {

/// A laser that is nowhere special in a room about the origin.
inline const Pose2 kInTheRoom(-0.4, 0.1, 0.2);

/// What a closed 360 degree laser of `beams` beams sees of the scene.
inline LaserScan closed_scan(const Scene& scene, const Pose2& world_T_laser, std::size_t beams,
                             double noise, std::mt19937_64& random) {
  SimulatedLaserParams laser;
  laser.beams = beams;
  laser.angle_increment = kTwoPi / static_cast<double>(beams);
  laser.noise = noise;
  const std::vector<float> ranges = simulate_ranges(scene, world_T_laser, laser, random);
  RawScan raw;
  raw.angle_min = laser.angle_min;
  raw.angle_increment = laser.angle_increment;
  raw.angle_max = laser.angle_min + static_cast<double>(beams - 1) * laser.angle_increment;
  raw.range_max = laser.range_max;
  raw.ranges = ranges.data();
  raw.range_count = ranges.size();
  LaserScan scan;
  normalize(raw, {}, scan);
  return scan;
}

/// A rectangular room of 6 m by 4 m with a pillar, seen from near its middle.
inline Scene room_with_pillar() {
  Scene scene;
  scene.add_box({0.0, 0.0, 0.0}, {6.0, 4.0});
  scene.add_box({1.6, 0.7, 1.0}, {0.6, 0.6});
  return scene;
}

/// Distance to the nearest end of a wall.
inline double distance_to_corner(const Scene& scene, const Eigen::Vector2d& point) {
  double nearest = 1e9;
  for (const Wall& wall : scene.walls) nearest = std::min(nearest, (wall.from - point).norm());
  return nearest;
}

}  // namespace test
}  // namespace falko_slam
