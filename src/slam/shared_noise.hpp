// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// No pose of one scan in another is better than this, however many points agree: what both have in
/// common stays, the laser's calibration and walls that are not straight.
inline Eigen::Matrix3d shared_noise() {
  constexpr double kDistance = 0.005, kTurn = 0.001;  // [m], [rad]
  return pose_covariance(kDistance, kTurn);
}

}  // namespace falko_slam
