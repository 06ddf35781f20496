// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "falko_slam/pose_graph/optimizer.hpp"
#include "relative_pose_factor.hpp"

namespace falko_slam {

/// A constraint as the solvers see it.
struct GraphFactor {
  std::size_t from, to;
  RelativePoseFactor factor;
  bool robust = false;  ///< the loss applies
  bool in_force = true;
};

/// A graph as the solvers see it: nodes by number, poses as (x, y, theta).
struct GraphProblem {
  std::vector<Eigen::Vector3d> poses;
  std::vector<bool> fixed;
  std::vector<GraphFactor> factors;

  /// `fixed`, and the first node of each connected part that holds no fixed one.
  std::vector<bool> anchored() const;
};

/// rho(s), rho'(s) and rho''(s) of a squared residual.
struct LossValue {
  double cost, slope, curvature;
};
LossValue evaluate_loss(Loss loss, double scale, double squared);

/// Of the factors in force.
struct GraphCost {
  double chi2 = 0.0;
  double cost = 0.0;  ///< with loss
};
GraphCost evaluate_cost(const GraphProblem& problem, const OptimizerParams& params);

/// Moves the poses. Fills in all but the initial and the final figures.
void solve_with_ceres(GraphProblem& problem, const OptimizerParams& params,
                      OptimizationSummary& summary);

}  // namespace falko_slam
