// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {
namespace {

// d(R p)/dtheta for the rotation of `pose`.
Eigen::Vector2d drotated_dtheta(const Pose2& pose, const Eigen::Vector2d& point) {
  const Eigen::Vector2d rotated = pose.rotation() * point;
  return {-rotated.y(), rotated.x()};
}

}  // namespace

Eigen::Matrix3d pose_covariance(double distance, double turn) {
  return Eigen::Vector3d(distance * distance, distance * distance, turn * turn).asDiagonal();
}

ComposeJacobians compose_jacobians(const Pose2& a_T_b, const Pose2& b_T_c) {
  ComposeJacobians jacobians{Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()};
  jacobians.dresult_dleft.topRightCorner<2, 1>() = drotated_dtheta(a_T_b, b_T_c.translation());
  jacobians.dresult_dright.topLeftCorner<2, 2>() = a_T_b.rotation();
  return jacobians;
}

Eigen::Matrix3d inverse_jacobian(const Pose2& a_T_b) {
  // b_T_a has the translation -R^T t, and d(R^T t)/dtheta = -(R^T t) turned by 90 degrees.
  const Pose2 b_T_a = a_T_b.inverse();
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  jacobian.topLeftCorner<2, 2>() = -b_T_a.rotation();
  jacobian.topRightCorner<2, 1>() << b_T_a.y(), -b_T_a.x();
  jacobian(2, 2) = -1.0;
  return jacobian;
}

PoseEstimate compose(const PoseEstimate& a_T_b, const PoseEstimate& b_T_c) {
  const auto [dleft, dright] = compose_jacobians(a_T_b.pose, b_T_c.pose);
  return {a_T_b.pose * b_T_c.pose, dleft * a_T_b.covariance * dleft.transpose() +
                                       dright * b_T_c.covariance * dright.transpose()};
}

PoseEstimate inverse(const PoseEstimate& a_T_b) {
  const Eigen::Matrix3d jacobian = inverse_jacobian(a_T_b.pose);
  return {a_T_b.pose.inverse(), jacobian * a_T_b.covariance * jacobian.transpose()};
}

PointEstimate transform(const PoseEstimate& a_T_b, const PointEstimate& point_in_b) {
  Eigen::Matrix<double, 2, 3> dpoint_dpose;
  dpoint_dpose << Eigen::Matrix2d::Identity(), drotated_dtheta(a_T_b.pose, point_in_b.point);
  const Eigen::Matrix2d rotation = a_T_b.pose.rotation();
  return {a_T_b.pose * point_in_b.point,
          dpoint_dpose * a_T_b.covariance * dpoint_dpose.transpose() +
              rotation * point_in_b.covariance * rotation.transpose()};
}

}  // namespace falko_slam
