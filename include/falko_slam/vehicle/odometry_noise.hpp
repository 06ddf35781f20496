// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// What the encoders of a tricycle do not say, as noise that is new on every piece of the way: its
/// effect grows with the root of the way, however finely it is cut.
struct OdometryNoise {
  double slip = 0.01;    ///< of the wheel's way [m / sqrt(m)], [0, 1]
  double steer = 0.005;  ///< of the steering [rad sqrt(m)], [0, 1]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const OdometryNoise& noise);

/// Of the arc's (x, y, theta) [m], [m], [rad], to first order.
Eigen::Matrix3d arc_covariance(const TricycleParams& tricycle, double ticks, double steering,
                               const OdometryNoise& noise);

}  // namespace falko_slam
