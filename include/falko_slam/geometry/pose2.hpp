// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <iosfwd>

namespace falko_slam {

/// Rigid motion of the plane, an element of SE(2).
///
/// A pose named `a_T_b` takes points of frame b to frame a and says where frame b stands in a:
///
///     point_in_a = a_T_b * point_in_b        a_T_c = a_T_b * b_T_c
///
/// Lengths are metres, the heading is in radians in [-pi, pi). Tangent vectors are (x, y, theta);
/// `exp` and `log` are the exponential map of the group and its inverse (\cite sola2018micro,
/// Eqs. (156)-(158)), `adjoint` takes a tangent vector of the local to the global frame (Eq.
/// (159)).
class Pose2 {
 public:
  Pose2() = default;
  Pose2(double x, double y, double theta);
  Pose2(const Eigen::Vector2d& translation, double theta);

  static Pose2 exp(const Eigen::Vector3d& tangent);
  Eigen::Vector3d log() const;

  double x() const { return translation_.x(); }
  double y() const { return translation_.y(); }
  double theta() const { return theta_; }
  const Eigen::Vector2d& translation() const { return translation_; }
  Eigen::Matrix2d rotation() const;

  Pose2 inverse() const;
  Pose2 operator*(const Pose2& other) const;
  Eigen::Vector2d operator*(const Eigen::Vector2d& point) const;

  /// pose * exp(t) * pose^-1 = exp(adjoint * t).
  Eigen::Matrix3d adjoint() const;

 private:
  Eigen::Vector2d translation_ = Eigen::Vector2d::Zero();
  double theta_ = 0.0;
  double cosine_ = 1.0;
  double sine_ = 0.0;
};

/// to - from in (x, y, theta), the angle the shorter way round.
Eigen::Vector3d difference(const Pose2& to, const Pose2& from);

std::ostream& operator<<(std::ostream& out, const Pose2& pose);

}  // namespace falko_slam
