// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/pose2.hpp"

#include <cmath>
#include <ostream>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// sin(theta) / theta and (1 - cos(theta)) / theta, smooth through zero.
struct ArcFactors {
  double along;
  double across;
};

ArcFactors arc_factors(double theta) {
  if (std::abs(theta) < 1e-4) {
    const double theta2 = theta * theta;
    return {1.0 - theta2 / 6.0, theta * (0.5 - theta2 / 24.0)};
  }
  const double half_sine = std::sin(0.5 * theta);  // 1 - cos without cancellation
  return {std::sin(theta) / theta, 2.0 * half_sine * half_sine / theta};
}

}  // namespace

Pose2::Pose2(double x, double y, double theta) : Pose2(Eigen::Vector2d(x, y), theta) {}

Pose2::Pose2(const Eigen::Vector2d& translation, double theta)
    : translation_(translation),
      theta_(wrap_angle(theta)),
      cosine_(std::cos(theta_)),
      sine_(std::sin(theta_)) {}

Pose2 Pose2::exp(const Eigen::Vector3d& tangent) {
  const auto [along, across] = arc_factors(tangent.z());
  return {along * tangent.x() - across * tangent.y(), across * tangent.x() + along * tangent.y(),
          tangent.z()};
}

Eigen::Vector3d Pose2::log() const {
  const auto [along, across] = arc_factors(theta_);
  const double determinant = along * along + across * across;
  return {(along * x() + across * y()) / determinant, (along * y() - across * x()) / determinant,
          theta_};
}

Eigen::Matrix2d Pose2::rotation() const {
  return (Eigen::Matrix2d() << cosine_, -sine_, sine_, cosine_).finished();
}

Pose2 Pose2::inverse() const {
  return {-cosine_ * x() - sine_ * y(), sine_ * x() - cosine_ * y(), -theta_};
}

Pose2 Pose2::operator*(const Pose2& other) const {
  return {*this * other.translation_, theta_ + other.theta_};
}

Eigen::Vector2d Pose2::operator*(const Eigen::Vector2d& point) const {
  return {x() + cosine_ * point.x() - sine_ * point.y(),
          y() + sine_ * point.x() + cosine_ * point.y()};
}

Eigen::Matrix3d Pose2::adjoint() const {
  return (Eigen::Matrix3d() << cosine_, -sine_, y(), sine_, cosine_, -x(), 0.0, 0.0, 1.0)
      .finished();
}

Eigen::Vector3d difference(const Pose2& to, const Pose2& from) {
  const Eigen::Vector2d way = to.translation() - from.translation();
  return {way.x(), way.y(), wrap_angle(to.theta() - from.theta())};
}

std::ostream& operator<<(std::ostream& out, const Pose2& pose) {
  return out << "(" << pose.x() << " m, " << pose.y() << " m, " << pose.theta() << " rad)";
}

}  // namespace falko_slam
