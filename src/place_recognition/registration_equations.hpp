// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace falko_slam {

/// A point of the source and the line that it is paired with.
struct PointToLine {
  Eigen::Vector2d normal;    ///< of the line, target frame
  Eigen::Vector2d arm;       ///< from the source's position to the point, target frame [m]
  Eigen::Vector2d position;  ///< of the point, source frame [m]
  double residual;           ///< distance to the line [m]
  double normal_gain;        ///< see SurfacePoint::normal_gain
};

/// What pairs say of the pose: gradient and information of half of the sum of squared residuals
/// over their variance, with respect to x, y and theta of the source in the target frame.
struct MeasuredPose {
  Eigen::Matrix3d information;
  Eigen::Vector3d gradient;
};

/// The normal equations of the point-to-line distances, about the position of the source:
///     r = n . (target_T_source p - q),  dr/d(x, y, theta) = (n_x, n_y, n . perp(R p)).
class RegistrationEquations {
 public:
  /// Of Cauchy's loss [m]; 0: squares.
  explicit RegistrationEquations(double loss_scale) : loss_scale_(loss_scale) {}

  void add(const PointToLine& pair);
  /// What comes next is no neighbour of what came last.
  void end_block();

  std::size_t pairs() const { return pairs_; }
  double mean_square() const;  ///< of the residuals [m^2]

  /// `weight` of a pair beside one of its own. `honest`: what the noise of the normals feigns is
  /// taken off; for near the right pose, where the residuals tell how great the noise is.
  MeasuredPose measured(double weight, bool honest) const;
  /// How much greater the variance of the gradient is than that of independent residuals: their
  /// design effect \cite kish1965, at least 1.
  double design_effect(const Eigen::Matrix3d& inverse) const;
  /// See Registration::constraint.
  double constraint() const;

 private:
  // Of a residual, without what a step of the pose will take off the sum of squares. [m^2]
  double variance(double explained) const;

  double loss_scale_;
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d feigned_ = Eigen::Matrix3d::Zero();  // per variance of a point
  Eigen::Vector3d gradient_ = Eigen::Vector3d::Zero();
  double squares_ = 0.0;
  double weights_ = 0.0;
  std::size_t pairs_ = 0;
  // Squares of the gradient's parts: of the pairs, and of the blocks of neighbouring pairs.
  Eigen::Matrix3d pair_scatter_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d block_scatter_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d block_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d block_begin_ = Eigen::Vector2d::Constant(1e9);
};

}  // namespace falko_slam
