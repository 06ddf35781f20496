// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// Lower triangular L with L L^T = covariance, zero where nothing is uncertain. False if it is not
/// symmetric to 1e-9 of its diagonal, not finite or has a negative eigenvalue beyond rounding.
template <int N>
bool factorise(const Eigen::Matrix<double, N, N>& covariance, Eigen::Matrix<double, N, N>& L) {
  if (!covariance.allFinite()) return false;
  L.setZero();
  for (int j = 0; j < N; ++j) {
    const double whole = covariance(j, j);
    const double pivot = whole - L.row(j).head(j).squaredNorm();
    if (whole < 0.0 || pivot < -1e-9 * whole) return false;
    L(j, j) = pivot > 1e-15 * whole ? std::sqrt(pivot) : 0.0;
    for (int i = j + 1; i < N; ++i) {
      const double scale = std::sqrt(std::abs(whole * covariance(i, i)));
      if (std::abs(covariance(i, j) - covariance(j, i)) > 1e-9 * scale) return false;
      const double rest = covariance(i, j) - L.row(i).head(j).dot(L.row(j).head(j));
      if (L(j, j) == 0.0 && std::abs(rest) > 1e-6 * scale) return false;
      L(i, j) = L(j, j) > 0.0 ? rest / L(j, j) : 0.0;
    }
  }
  return true;
}

template <int N>
bool is_positive_semidefinite(const Eigen::Matrix<double, N, N>& covariance) {
  Eigen::Matrix<double, N, N> L;
  return factorise<N>(covariance, L);
}

template <int N>
bool is_positive_definite(const Eigen::Matrix<double, N, N>& covariance) {
  Eigen::Matrix<double, N, N> L;
  return factorise<N>(covariance, L) && (L.diagonal().array() > 0.0).all();
}

inline bool is_finite(const Pose2& pose) {
  return pose.translation().allFinite() && std::isfinite(pose.theta());
}

/// Finite, with a covariance that is one.
inline bool is_usable(const PoseEstimate& estimate) {
  return is_finite(estimate.pose) && is_positive_semidefinite<3>(estimate.covariance);
}

}  // namespace falko_slam
