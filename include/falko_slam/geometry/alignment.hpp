// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// The same point seen from two frames.
struct PointPair {
  Eigen::Vector2d point_in_target = Eigen::Vector2d::Zero();
  Eigen::Vector2d point_in_source = Eigen::Vector2d::Zero();
  double weight = 1.0;  ///< proportional to the inverse of the variance; positive
};

struct Alignment {
  PoseEstimate target_T_source;
  double rms_residual = 0.0;  ///< weighted, over both coordinates of all pairs [m]
};

/// The rigid motion that minimises sum_i w_i |target_T_source * source_i - target_i|^2 in closed
/// form, with its covariance.
///
/// The covariance is that of isotropic residuals with standard deviation `residual_noise` [m] at
/// weight 1 where that is positive, else estimated from the residuals (2 n - 3 degrees of freedom;
/// zero for two pairs that fit exactly).
/// Empty for fewer than two pairs, or where all points of one side coincide (no orientation).
std::optional<Alignment> align(const std::vector<PointPair>& pairs, double residual_noise = 0.0);

}  // namespace falko_slam
