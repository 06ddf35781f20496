// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// A straight piece of wall, from one end to the other [m].
struct Wall {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
};

/// A plane world of walls.
struct Scene {
  std::vector<Wall> walls;

  /// Four walls around a rectangle of `size` (along its x and y), its centre at `world_T_center`.
  void add_box(const Pose2& world_T_center, const Eigen::Vector2d& size);

  /// Distance along the ray from the pose's position in its heading to the first wall [m]; infinity
  /// if it meets none.
  double cast(const Pose2& world_T_ray) const;
};

/// A corridor with offices on both sides, pillars and furniture, 24 m by 16 m about the origin.
Scene office_scene();

/// A closed way along the corridor and back, in steps of `step` [m].
/// Throws std::invalid_argument unless the step is in [0.0001, 8.5].
std::vector<Pose2> office_path(double step);

}  // namespace falko_slam
