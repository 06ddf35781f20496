// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/odometry_noise.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {

void validate(const OdometryNoise& noise) {
  require_in_range("slip", noise.slip, 0.0, 1.0);
  require_in_range("steer", noise.steer, 0.0, 1.0);
}

// The variance of the way's error is slip^2 |w|. That of the steering's mean over a way w is
// steer^2 / |w|: so the turn's, (w cos(a) / L)^2 times that, is proportional to w as well.
Eigen::Matrix3d arc_covariance(const TricycleParams& tricycle, double ticks, double steering,
                               const OdometryNoise& noise) {
  const double way = std::abs(tricycle.driving_scale * ticks);
  if (way == 0.0) return Eigen::Matrix3d::Zero();
  const Eigen::Vector2d variances(
      noise.slip * noise.slip * way / (tricycle.driving_scale * tricycle.driving_scale),
      noise.steer * noise.steer / way);
  const Eigen::Matrix<double, 3, 2> slopes = arc_jacobians(tricycle, ticks, steering).darc_dcontrol;
  return slopes * variances.asDiagonal() * slopes.transpose();
}

}  // namespace falko_slam
