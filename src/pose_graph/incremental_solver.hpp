// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "graph_problem.hpp"

namespace falko_slam {

/// Gauss-Newton for a graph that grows, at the price of a few passes over it.
///
/// Each step solves H delta = -g, H and g of all factors in force at the present poses, by
/// conjugate gradients. Their preconditioner is the graph as it was factorised last, and new nodes
/// hung to it by one constraint each, which is solved exactly: a new closure is then a change of
/// rank three, worth four iterations. The steps are taken in the frames of the nodes
/// (t += R delta_t, theta += delta_theta), where H does not change when a stretch of the map is
/// moved as a whole. Only the preconditioner is ever old, never the equations.
class IncrementalSolver {
 public:
  /// Moves the poses to the optimum next to them. False where it cannot, the poses as they were:
  /// a step that does not pay, a graph that is loose.
  /// Roughly: to within a standard deviation.
  bool solve(GraphProblem& problem, const OptimizerParams& params, OptimizationSummary& summary,
             bool roughly = false);

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  // A whitened factor at the present poses, weighted with the slope of its loss.
  struct Row {
    std::size_t from, to;
    Eigen::Matrix3d dfrom, dto;
    Eigen::Vector3d residual;
  };
  // A new node hung to an older one by the factor of a row.
  struct Branch {
    std::size_t row, node, parent;
    Eigen::Matrix3d dnode_inverse, dparent;
  };

  double linearize(const GraphProblem& problem, const OptimizerParams& params);
  bool factorize();
  bool hang_new_nodes();
  bool prepare();
  Eigen::VectorXd gradient() const;
  Eigen::VectorXd times_hessian(const Eigen::VectorXd& x) const;
  Eigen::VectorXd precondition(const Eigen::VectorXd& b) const;
  bool conjugate_gradients(const Eigen::VectorXd& right, Eigen::VectorXd& x);
  bool step(const Eigen::VectorXd& right, Eigen::VectorXd& x);

  std::vector<Row> rows_;
  std::vector<bool> anchored_;
  std::vector<bool> base_anchored_;   // of the nodes that are factorised
  std::vector<Eigen::Index> column_;  // of them, -1 for an anchored one
  std::vector<Branch> branches_;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> base_;
};

}  // namespace falko_slam
