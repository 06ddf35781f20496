// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "linear_graph.hpp"

#include "block_ordering.hpp"

namespace falko_slam {
namespace {

constexpr double kLoose = 1e-12;  // what is left of a diagonal element, as a part of it

}  // namespace

LinearGraph::LinearGraph(const GraphProblem& problem, const OptimizerParams& params) {
  BlockPattern pattern(problem.anchored());
  for (const GraphFactor& f : problem.factors) {
    if (f.in_force) pattern.add(f.from, f.to);
  }
  column_ = pattern.order();
  BlockMatrix hessian(3 * pattern.size());
  for (const GraphFactor& f : problem.factors) {
    if (!f.in_force) continue;
    const auto [residual, dfrom, dto] =
        f.factor.linearize(problem.poses[f.from], problem.poses[f.to]);
    LossValue loss{0.0, 1.0, 0.0};
    if (f.robust) {
      loss = evaluate_loss(params.closure_loss, params.loss_scale, residual.squaredNorm());
    }
    const Eigen::Index from = column_[f.from], to = column_[f.to];
    hessian.add(from, from, loss.slope * dfrom.transpose() * dfrom);
    hessian.add(to, to, loss.slope * dto.transpose() * dto);
    if (from > to) hessian.add(from, to, loss.slope * dfrom.transpose() * dto);
    if (to > from) hessian.add(to, from, loss.slope * dto.transpose() * dfrom);
  }
  const Eigen::SparseMatrix<double> lower = hessian.lower_triangle();
  factor_.compute(lower);
  if (factor_.info() != Eigen::Success) return;
  const Eigen::VectorXd pivots = factor_.vectorD(), diagonal = lower.diagonal();
  solvable_ = (pivots.array() > kLoose * diagonal.array()).all();
}

Eigen::Matrix3d LinearGraph::covariance(std::size_t node) const {
  const Eigen::Index column = column_[node];
  if (column < 0) return Eigen::Matrix3d::Zero();
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(factor_.rows(), 3);
  unit.block<3, 3>(column, 0).setIdentity();
  const Eigen::Matrix3d block = factor_.solve(unit).middleRows<3>(column);
  return 0.5 * (block + block.transpose());
}

}  // namespace falko_slam
