// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "graph_problem.hpp"

namespace falko_slam {

/// The graph about its present poses as a linear least-squares problem, H = J^T W J over the nodes
/// that are not anchored, factorised. W weights a robust factor with the slope of its loss.
class LinearGraph {
 public:
  LinearGraph(const GraphProblem& problem, const OptimizerParams& params);

  /// False where the factors leave the graph loose.
  bool solvable() const { return solvable_; }
  /// Block of H^-1 of a node; zero for an anchored one.
  Eigen::Matrix3d covariance(std::size_t node) const;

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  std::vector<Eigen::Index> column_;  // first of each node, -1 for an anchored one
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
  bool solvable_ = false;
};

}  // namespace falko_slam
