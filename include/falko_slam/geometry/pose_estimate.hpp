// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// A pose a_T_b and how sure we are of it.
///
/// The covariance is that of the additive error of (x, y, theta) with x and y along the axes of
/// frame a: the convention of geometry_msgs/PoseWithCovariance. Units m^2, m rad, rad^2.
struct PoseEstimate {
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Of a position known alike in all directions and a heading independent of it, from their standard
/// deviations [m], [rad].
Eigen::Matrix3d pose_covariance(double distance, double turn);

/// A point of some frame with the covariance of its coordinates [m^2].
struct PointEstimate {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// Jacobians of a_T_c = a_T_b * b_T_c with respect to the coordinates (x, y, theta) of both sides.
struct ComposeJacobians {
  Eigen::Matrix3d dresult_dleft;
  Eigen::Matrix3d dresult_dright;
};
ComposeJacobians compose_jacobians(const Pose2& a_T_b, const Pose2& b_T_c);

/// Jacobian of b_T_a = a_T_b^-1 with respect to the coordinates of a_T_b.
Eigen::Matrix3d inverse_jacobian(const Pose2& a_T_b);

/// a_T_b * b_T_c to first order; the two errors are taken as independent.
PoseEstimate compose(const PoseEstimate& a_T_b, const PoseEstimate& b_T_c);

/// b_T_a to first order.
PoseEstimate inverse(const PoseEstimate& a_T_b);

/// a_T_b * point_in_b to first order; the two errors are taken as independent.
PointEstimate transform(const PoseEstimate& a_T_b, const PointEstimate& point_in_b);

}  // namespace falko_slam
