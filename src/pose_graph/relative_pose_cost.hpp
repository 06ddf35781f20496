// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ceres/sized_cost_function.h>

#include "relative_pose_factor.hpp"

namespace falko_slam {

/// The factor in Ceres' words: blocks (x, y, theta) of `from` and of `to`.
class RelativePoseCost : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  /// Borrows the factor.
  explicit RelativePoseCost(const RelativePoseFactor& factor) : factor_(factor) {}

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    using Vector = Eigen::Map<const Eigen::Vector3d>;
    using Matrix = Eigen::Map<RelativePoseFactor::RowMajor>;
    const Vector from(parameters[0]), to(parameters[1]);
    if (jacobians == nullptr) {
      Eigen::Map<Eigen::Vector3d>(residuals, 3) = factor_.residual(from, to);
      return true;
    }
    const RelativePoseFactor::Linearization linear = factor_.linearize(from, to);
    Eigen::Map<Eigen::Vector3d>(residuals, 3) = linear.residual;
    if (jacobians[0] != nullptr) Matrix(jacobians[0], 3, 3) = linear.dfrom;
    if (jacobians[1] != nullptr) Matrix(jacobians[1], 3, 3) = linear.dto;
    return true;
  }

 private:
  const RelativePoseFactor& factor_;
};

}  // namespace falko_slam
