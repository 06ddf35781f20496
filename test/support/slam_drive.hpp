// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/slam/feature_slam.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace test {

inline const Pose2 kDriveMount{0.3, 0.0, 0.1};  // of the laser

/// Takes so many steps of 0.25 m round the office, with an odometry that is right.
inline void drive_office(FeatureSlam& slam, std::size_t steps) {
  auto random = seeded_random();
  const Scene scene = office_scene();
  const std::vector<Pose2> path = office_path(0.25);
  for (std::size_t i = 0; i < steps; ++i) {
    SlamScan scan;
    scan.stamp = Time(from_seconds(100.0 + 0.125 * static_cast<double>(i)));
    scan.odom_T_base = path[i % path.size()];
    scan.base_T_laser = kDriveMount;
    scan.scan = closed_scan(scene, *scan.odom_T_base * kDriveMount, 360, 0.01, random);
    slam.add(scan);
  }
}

}  // namespace test
}  // namespace falko_slam
