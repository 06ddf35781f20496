// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "falko_slam/place_recognition/scan_view.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace test {

/// What a closed laser sees from a pose.
inline ScanView view_of(const Scene& scene, const Pose2& world_T_laser, std::mt19937_64& random,
                        double noise = 0.01, std::size_t beams = 720) {
  return ScanView(closed_scan(scene, world_T_laser, beams, noise, random));
}

inline Scene square_room() {
  Scene scene;
  scene.add_box({}, {6.0, 6.0});
  return scene;
}

}  // namespace test
}  // namespace falko_slam
