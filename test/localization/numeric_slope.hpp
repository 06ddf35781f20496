// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {
namespace test {

/// Of numeric differentiation.
constexpr double kStep = 1e-6;

/// One of (x, y, theta) moved.
inline Pose2 shifted(const Pose2& pose, int coordinate, double by) {
  Eigen::Vector3d q(pose.x(), pose.y(), pose.theta());
  q[coordinate] += by;
  return {q[0], q[1], q[2]};
}

}  // namespace test
}  // namespace falko_slam
