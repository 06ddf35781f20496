// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "linear_graph.hpp"

namespace falko_slam {
namespace {

constexpr double kLoose = 1e-12;  // a pivot below this part of the largest

void add_block(std::vector<Eigen::Triplet<double>>& entries, Eigen::Index row, Eigen::Index column,
               const Eigen::Matrix3d& block) {
  if (row < 0 || column < 0) return;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      if (row + i >= column + j) entries.emplace_back(row + i, column + j, block(i, j));
    }
  }
}

}  // namespace

LinearGraph::LinearGraph(const GraphProblem& problem, const OptimizerParams& params) {
  Eigen::Index size = 0;
  for (const bool anchored : problem.anchored()) {
    column_.push_back(anchored ? -1 : size);
    if (!anchored) size += 3;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const GraphFactor& f : problem.factors) {
    if (!f.in_force) continue;
    const auto [residual, dfrom, dto] =
        f.factor.linearize(problem.poses[f.from], problem.poses[f.to]);
    const double weight =
        f.robust
            ? evaluate_loss(params.closure_loss, params.loss_scale, residual.squaredNorm()).slope
            : 1.0;
    const Eigen::Index from = column_[f.from], to = column_[f.to];
    add_block(entries, from, from, weight * dfrom.transpose() * dfrom);
    add_block(entries, to, to, weight * dto.transpose() * dto);
    if (from > to) add_block(entries, from, to, weight * dfrom.transpose() * dto);
    if (to > from) add_block(entries, to, from, weight * dto.transpose() * dfrom);
  }
  Matrix hessian(size, size);
  hessian.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(hessian);
  if (factor_.info() != Eigen::Success) return;
  const Eigen::VectorXd pivots = factor_.vectorD();
  solvable_ = size == 0 || pivots.minCoeff() > kLoose * pivots.maxCoeff();
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
