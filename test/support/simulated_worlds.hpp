// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/simulation/laser_scanner.hpp"

namespace falko_slam {
namespace test {

constexpr std::size_t kMatt = 0;
constexpr std::size_t kDark = 1;
constexpr std::size_t kReflector = 2;

/// Surfaces, and nothing yet that has them.
inline World empty_world() {
  World world;
  world.surfaces = {{"matt", 0.5, 0.0}, {"dark", 0.1, 0.0}, {"reflector", 0.5, 500.0}};
  return world;
}

inline World world_with_wall_at(double x, std::size_t surface = kMatt) {
  World world = empty_world();
  world.fixed.faces.push_back({{x, -1000.0}, {x, 1000.0}, surface});
  return world;
}

/// Of a beam, from the laser [rad].
inline double bearing(const LaserModel& laser, std::size_t beam) {
  return laser.angle_min + static_cast<double>(beam) * laser.angle_increment;
}

/// A NAV350 of infinitely thin beams, without noise and without drop-outs.
inline LaserModel ideal_laser() {
  LaserModel laser;
  laser.nearest = 0.01;
  laser.range_of_dark = 1000.0;
  laser.beam_diameter = 0.0;
  laser.beam_divergence = 0.0;
  laser.range_noise = 0.0;
  laser.range_step = 0.0;
  laser.bearing_noise = 0.0;
  laser.drop_out = 0.0;
  return laser;
}

constexpr Time kBegin{std::chrono::seconds(10)};

/// At rest, or on an arc of this tangent a second, for a second.
inline MotionTrack track_of(const Pose2& world_T_base,
                            const Eigen::Vector3d& tangent = Eigen::Vector3d::Zero()) {
  MotionTrack track(kBegin, world_T_base);
  for (int i = 0; i < 1000; ++i) track.add(std::chrono::milliseconds(1), 1e-3 * tangent);
  return track;
}

}  // namespace test
}  // namespace falko_slam
