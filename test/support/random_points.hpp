// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace test {

/// Evenly in the square of `size` about the origin.
inline std::vector<Eigen::Vector2d> random_points(std::size_t count, double size,
                                                  std::mt19937_64& random) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(random, -0.5 * size, 0.5 * size);
    points.emplace_back(x, uniform(random, -0.5 * size, 0.5 * size));
  }
  return points;
}

inline std::vector<Eigen::Vector2d> moved(const Pose2& pose,
                                          const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> result;
  for (const auto& point : points) result.push_back(pose * point);
  return result;
}

}  // namespace test
}  // namespace falko_slam
