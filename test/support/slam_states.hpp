// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/slam_drives.hpp"

namespace falko_slam {
namespace test {

/// Of a short drive along the office's corridor.
inline SlamState office_state(double length, std::uint64_t seed = kSeed, std::size_t beams = 180) {
  std::mt19937_64 random(seed);
  FeatureSlam slam;
  run(slam, slam_drive(office_scene(), straight({-8.0, -1.0, 0.0}, length, 0.2), random, beams));
  slam.finish();
  return slam.state();
}

}  // namespace test
}  // namespace falko_slam
