// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "shared_halt.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {
namespace {

constexpr double kSamePoint = 0.05;  // of averages over scans from one halt [m]

Eigen::Matrix3d information_of(const Eigen::Vector2d& point) {
  Eigen::Matrix<double, 2, 3> J;
  J << 1.0, 0.0, -point.y(), 0.0, 1.0, point.x();
  return J.transpose() * J;
}

}  // namespace

Eigen::Matrix3d covariance_at_halt(const ReflectorMotion& before, const ReflectorMotion& after,
                                   double lasting_noise) {
  double greatest_weight = 0.0;
  Eigen::Matrix3d N_before = Eigen::Matrix3d::Zero(), N_after = N_before, common = N_before;
  for (const PointPair& pair : before.pairs) {
    N_before += pair.weight * information_of(pair.point_in_source);
    greatest_weight = std::max(greatest_weight, pair.weight);
  }
  for (const PointPair& pair : after.pairs) {
    N_after += pair.weight * information_of(pair.point_in_target);
    greatest_weight = std::max(greatest_weight, pair.weight);
  }
  for (const PointPair& end : before.pairs) {
    for (const PointPair& start : after.pairs) {
      if ((end.point_in_source - start.point_in_target).norm() > kSamePoint) continue;
      common += end.weight * start.weight * information_of(start.point_in_target);
      break;
    }
  }
  // No more than the weights have room for, at two ends.
  const double variance = std::min(lasting_noise * lasting_noise, 0.5 / greatest_weight);
  const Eigen::Matrix3d displaced = variance * N_before.inverse() * common * N_after.inverse();
  const Eigen::Matrix3d dbefore = compose_jacobians(before.start_T_end.pose, {}).dresult_dright;
  const Eigen::Matrix3d dafter = compose_jacobians({}, after.start_T_end.pose).dresult_dleft;
  return -dbefore * displaced * dafter.transpose();
}

}  // namespace falko_slam
