// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/sensor/scan_normalizer.hpp"
#include "support/seeds.hpp"
#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace test {

/// A matt square room around the laser [m], with reflectors of 80 mm in it.
inline World room_with_reflectors(const std::vector<Eigen::Vector2d>& centers, double size = 60.0) {
  World world = empty_world();
  add_box(world.fixed, {}, {size, size}, kMatt);
  for (const Eigen::Vector2d& center : centers) {
    world.fixed.cylinders.push_back({center, 0.04, kReflector});
  }
  return world;
}

/// What a laser at rest sees of it.
inline LaserScan look_at(const World& world, const Pose2& world_T_laser, const LaserModel& laser,
                         std::mt19937_64& random) {
  LaserScanner scanner(laser, {}, world, kBegin);
  LaserScan scan;
  normalize(as_raw_scan(laser, scanner.scan(kBegin, track_of(world_T_laser), random)), {}, scan);
  return scan;
}

inline LaserScan look_at(const World& world) {
  auto random = seeded_random();
  return look_at(world, {}, LaserModel(), random);
}

}  // namespace test
}  // namespace falko_slam
