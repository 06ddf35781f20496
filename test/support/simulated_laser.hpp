// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "support/scene.hpp"

namespace falko_slam {

/// Default: the geometry of a SICK NAV350.
struct SimulatedLaserParams {
  std::size_t beams = 1440;
  double angle_min = -kPi;                   ///< [rad]
  double angle_increment = kTwoPi / 1440.0;  ///< [rad]
  double range_max = 100.0;                  ///< [m]
  double noise = 0.01;                       ///< standard deviation of a range [m]
};

/// Ranges [m] seen from the pose, all beams at one instant; 0 where nothing is within range_max.
std::vector<float> simulate_ranges(const Scene& scene, const Pose2& world_T_laser,
                                   const SimulatedLaserParams& params, std::mt19937_64& random);

/// The same of a laser that turns while it moves: the first beam is taken at `world_T_first`, the
/// last one nearly `first_T_next` farther, where the next scan begins; velocity and turn are
/// constant.
std::vector<float> simulate_moving_ranges(const Scene& scene, const Pose2& world_T_first,
                                          const Pose2& first_T_next,
                                          const SimulatedLaserParams& params,
                                          std::mt19937_64& random);

}  // namespace falko_slam
