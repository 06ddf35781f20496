// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simulated_laser.hpp"

#include <algorithm>

namespace falko_slam {

std::vector<float> simulate_ranges(const Scene& scene, const Pose2& world_T_laser,
                                   const SimulatedLaserParams& params, std::mt19937_64& random) {
  return simulate_moving_ranges(scene, world_T_laser, Pose2(), params, random);
}

std::vector<float> simulate_moving_ranges(const Scene& scene, const Pose2& world_T_first,
                                          const Pose2& first_T_next,
                                          const SimulatedLaserParams& params,
                                          std::mt19937_64& random) {
  const Eigen::Vector3d way = first_T_next.log();
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<float> ranges;
  ranges.reserve(params.beams);
  for (std::size_t i = 0; i < params.beams; ++i) {
    const double bearing = params.angle_min + static_cast<double>(i) * params.angle_increment;
    const double share = static_cast<double>(i) / static_cast<double>(params.beams);
    const Pose2 world_T_laser =
        way.isZero(0.0) ? world_T_first : world_T_first * Pose2::exp(share * way);
    const double range =
        scene.cast(world_T_laser * Pose2(0.0, 0.0, bearing)) + params.noise * noise(random);
    ranges.push_back(range <= params.range_max ? static_cast<float>(std::max(0.0, range)) : 0.0F);
  }
  return ranges;
}

}  // namespace falko_slam
