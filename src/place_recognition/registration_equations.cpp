// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "registration_equations.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

// A direction of which the noise of the normals may feign this share and more is not measured.
constexpr double kFeignedShare = 0.5;

}  // namespace

double RegistrationEquations::mean_square() const { return squares_ / weights_; }

double RegistrationEquations::variance(double explained) const {
  const auto pairs = static_cast<double>(pairs_);
  return std::max((squares_ - explained) / weights_ * pairs / (pairs - 3.0), 1e-12);
}

// A normal that is off by phi turns into n + phi t: information_ has grown by
// E[phi^2] (J_t^T J_t), which is feigned_ times the variance of a point. In the eigenvectors of
// feigned_ relative to information_ both are diagonal, and each direction keeps its true share.
MeasuredPose RegistrationEquations::measured(double weight, bool honest) const {
  const Eigen::Matrix3d information = information_.matrix();
  const Eigen::LLT<Eigen::Matrix3d> cholesky(information);
  if (cholesky.info() != Eigen::Success) {
    const double scale = weight / variance(0.0);
    return {scale * information, scale * gradient_};
  }
  const Eigen::Matrix3d lower = cholesky.matrixL();
  const Eigen::Matrix3d inverse = cholesky.matrixL().solve(Eigen::Matrix3d::Identity().eval());
  const double noise = variance((inverse * gradient_).squaredNorm());
  const double scale = weight / noise;
  if (!honest) return {scale * information, scale * gradient_};
  const Eigen::Matrix3d relative = noise * inverse * feigned_.matrix() * inverse.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shares;
  shares.computeDirect(relative);
  const Eigen::Vector3d kept = shares.eigenvalues().unaryExpr(
      [](double share) { return share < kFeignedShare ? 1.0 - share : 0.0; });
  const Eigen::Matrix3d vectors = shares.eigenvectors();
  const Eigen::Matrix3d keep = vectors * kept.asDiagonal() * vectors.transpose();
  return {scale * lower * keep * lower.transpose(), scale * lower * keep * inverse * gradient_};
}

double RegistrationEquations::design_effect(const Eigen::Matrix3d& inverse) const {
  const double of_pairs = (inverse * pair_scatter_.matrix()).trace();
  const double of_blocks = (inverse * block_scatter_.matrix()).trace();
  return of_pairs > 0.0 ? std::max(1.0, of_blocks / of_pairs) : 1.0;
}

double RegistrationEquations::constraint() const {
  const Eigen::Matrix2d scatter = information_.matrix().topLeftCorner<2, 2>();
  const double half_trace = 0.5 * scatter.trace();
  const double half_difference = 0.5 * (scatter(0, 0) - scatter(1, 1));
  return (half_trace - std::hypot(half_difference, scatter(0, 1))) / half_trace;
}

}  // namespace falko_slam
