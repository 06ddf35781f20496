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

/// Sum of weighted squares v v^T of vectors (x, y, theta): the lower half of a symmetric matrix.
class SquareSum {
 public:
  void add(double weight, double x, double y, double theta) {
    const double wx = weight * x, wy = weight * y;
    xx_ += wx * x;
    xy_ += wx * y;
    xt_ += wx * theta;
    yy_ += wy * y;
    yt_ += wy * theta;
    tt_ += weight * theta * theta;
  }
  Eigen::Matrix3d matrix() const {
    Eigen::Matrix3d result;
    result << xx_, xy_, xt_, xy_, yy_, yt_, xt_, yt_, tt_;
    return result;
  }

 private:
  double xx_ = 0.0, xy_ = 0.0, xt_ = 0.0, yy_ = 0.0, yt_ = 0.0, tt_ = 0.0;
};

/// The normal equations of the point-to-line distances, about the position of the source:
///     r = n . (target_T_source p - q),  dr/d(x, y, theta) = (n_x, n_y, n . perp(R p)).
class RegistrationEquations {
 public:
  /// Of Cauchy's loss [m]; 0: squares.
  explicit RegistrationEquations(double loss_scale)
      : loss_(loss_scale > 0.0 ? 1.0 / (loss_scale * loss_scale) : 0.0) {}

  void add(const PointToLine& pair) {
    if ((pair.position - block_begin_).squaredNorm() > kBlock * kBlock) {
      end_block();
      block_begin_ = pair.position;
    }
    const double nx = pair.normal.x(), ny = pair.normal.y();
    const double turn = ny * pair.arm.x() - nx * pair.arm.y();
    const double square = pair.residual * pair.residual;
    const double weight = 1.0 / (1.0 + loss_ * square);
    const double pull = weight * pair.residual;
    information_.add(weight, nx, ny, turn);
    // What a turn of the normal would add: it points along the wall then.
    feigned_.add(weight * pair.normal_gain, -ny, nx, nx * pair.arm.x() + ny * pair.arm.y());
    pair_scatter_.add(pull * pull, nx, ny, turn);
    block_ += pull * Eigen::Vector3d(nx, ny, turn);
    squares_ += weight * square;
    weights_ += weight;
    ++pairs_;
  }
  /// What comes next is no neighbour of what came last.
  void end_block() {
    block_scatter_.add(1.0, block_.x(), block_.y(), block_.z());
    gradient_ += block_;
    block_.setZero();
    block_begin_.setConstant(1e9);
  }

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
  // Neighbouring residuals are alike (they share beams and normals, walls are not straight): the
  // gradient is also summed over blocks of wall of this length, whose sums are independent. [m]
  static constexpr double kBlock = 0.5;

  // Of a residual, without what a step of the pose will take off the sum of squares. [m^2]
  double variance(double explained) const;

  double loss_;  // [1/m^2]
  SquareSum information_;
  SquareSum feigned_;  // per variance of a point
  Eigen::Vector3d gradient_ = Eigen::Vector3d::Zero();
  double squares_ = 0.0;
  double weights_ = 0.0;
  std::size_t pairs_ = 0;
  // Squares of the gradient's parts: of the pairs, and of the blocks of neighbouring pairs.
  SquareSum pair_scatter_;
  SquareSum block_scatter_;
  Eigen::Vector3d block_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d block_begin_ = Eigen::Vector2d::Constant(1e9);
};

}  // namespace falko_slam
