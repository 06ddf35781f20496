// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
#include "support/scene.hpp"

namespace falko_slam {
namespace test {

/// What an ideal laser sees of a room of 10 m by 6 m about the origin with a box in a corner of it.
inline Scene room_with_box() {
  Scene scene;
  scene.add_box({}, {10.0, 6.0});
  scene.add_box({3.0, 1.5, 0.3}, {1.0, 0.8});
  return scene;
}

/// All beams at one instant.
inline LaserScan scan_of(const Scene& scene, const Pose2& world_T_laser, std::size_t beams = 360) {
  LaserScan scan;
  scan.angle_min = -kPi;
  scan.angle_increment = kTwoPi / static_cast<double>(beams);
  scan.range_max = 100.0;
  scan.closed = true;
  scan.status.assign(beams, BeamStatus::kValid);
  for (std::size_t beam = 0; beam < beams; ++beam) {
    scan.ranges.push_back(scene.cast(world_T_laser * Pose2(0.0, 0.0, scan.bearing(beam))));
  }
  return scan;
}

}  // namespace test
}  // namespace falko_slam
