// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/alignment.hpp"

#include <Eigen/LU>
#include <cmath>

namespace falko_slam {
namespace {

struct Centroids {
  Eigen::Vector2d target = Eigen::Vector2d::Zero();
  Eigen::Vector2d source = Eigen::Vector2d::Zero();
  double weight = 0.0;
};

Centroids centroids(const std::vector<PointPair>& pairs) {
  Centroids mean;
  for (const auto& pair : pairs) {
    mean.weight += pair.weight;
    mean.target += pair.weight * pair.point_in_target;
    mean.source += pair.weight * pair.point_in_source;
  }
  mean.target /= mean.weight;
  mean.source /= mean.weight;
  return mean;
}

// J^T J of the residuals R(theta) s_i + t - q_i in (x, y, theta).
Eigen::Matrix3d information(const std::vector<PointPair>& pairs, const Pose2& target_T_source) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& pair : pairs) {
    const Eigen::Vector2d rotated = target_T_source.rotation() * pair.point_in_source;
    const Eigen::Vector2d dresidual_dtheta(-rotated.y(), rotated.x());
    sum.topLeftCorner<2, 2>().diagonal().array() += pair.weight;
    sum.topRightCorner<2, 1>() += pair.weight * dresidual_dtheta;
    sum(2, 2) += pair.weight * rotated.squaredNorm();
  }
  sum.bottomLeftCorner<1, 2>() = sum.topRightCorner<2, 1>().transpose();
  return sum;
}

}  // namespace

std::optional<Alignment> align(const std::vector<PointPair>& pairs, double residual_noise) {
  if (pairs.size() < 2) return std::nullopt;
  const Centroids mean = centroids(pairs);
  double cosine = 0.0;
  double sine = 0.0;
  for (const auto& pair : pairs) {
    const Eigen::Vector2d s = pair.point_in_source - mean.source;
    const Eigen::Vector2d q = pair.point_in_target - mean.target;
    cosine += pair.weight * s.dot(q);
    sine += pair.weight * (s.x() * q.y() - s.y() * q.x());
  }
  if (!(std::hypot(cosine, sine) > 0.0)) return std::nullopt;

  const double theta = std::atan2(sine, cosine);
  const Eigen::Vector2d translation = mean.target - Pose2(0.0, 0.0, theta).rotation() * mean.source;
  Alignment result;
  result.target_T_source.pose = Pose2(translation, theta);

  double squares = 0.0;
  for (const auto& pair : pairs) {
    squares +=
        pair.weight *
        (result.target_T_source.pose * pair.point_in_source - pair.point_in_target).squaredNorm();
  }
  result.rms_residual = std::sqrt(squares / (2.0 * mean.weight));
  const double freedom = 2.0 * static_cast<double>(pairs.size()) - 3.0;
  const double variance =
      residual_noise > 0.0 ? residual_noise * residual_noise : squares / freedom;
  result.target_T_source.covariance =
      variance * information(pairs, result.target_T_source.pose).inverse();
  return result;
}

}  // namespace falko_slam
