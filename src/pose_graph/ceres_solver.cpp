// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <deque>
#include <memory>

#include "graph_problem.hpp"
#include "relative_pose_cost.hpp"

namespace falko_slam {
namespace {

std::unique_ptr<ceres::LossFunction> make_loss(const OptimizerParams& params) {
  switch (params.closure_loss) {
    case Loss::kNone:
      break;
    case Loss::kHuber:
      return std::make_unique<ceres::HuberLoss>(params.loss_scale);
    case Loss::kCauchy:
      return std::make_unique<ceres::CauchyLoss>(params.loss_scale);
  }
  return nullptr;
}

ceres::Problem::Options problem_options() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

ceres::SparseLinearAlgebraLibraryType sparse_library() {
  for (const auto library : {ceres::SUITE_SPARSE, ceres::EIGEN_SPARSE}) {
    if (ceres::IsSparseLinearAlgebraLibraryTypeAvailable(library)) return library;
  }
  return ceres::CX_SPARSE;
}

ceres::Solver::Options solver_options(const OptimizerParams& params) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = sparse_library();
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = params.max_iterations;
  // So wide a region makes the first steps those of Gauss-Newton; one that fails narrows it.
  options.initial_trust_region_radius = 1e16;
  options.max_trust_region_radius = 1e32;
  options.function_tolerance = 1e-9;
  options.gradient_tolerance = 1e-9;
  options.parameter_tolerance = 1e-10;
  return options;
}

}  // namespace

void solve_with_ceres(GraphProblem& graph, const OptimizerParams& params,
                      OptimizationSummary& summary) {
  const std::unique_ptr<ceres::LossFunction> loss = make_loss(params);
  std::deque<RelativePoseCost> costs;
  ceres::Problem problem(problem_options());
  for (Eigen::Vector3d& pose : graph.poses) problem.AddParameterBlock(pose.data(), 3);
  for (const GraphFactor& f : graph.factors) {
    if (!f.in_force) continue;
    costs.emplace_back(f.factor);
    problem.AddResidualBlock(&costs.back(), f.robust ? loss.get() : nullptr,
                             graph.poses[f.from].data(), graph.poses[f.to].data());
  }
  const std::vector<bool> anchored = graph.anchored();
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    if (anchored[i]) problem.SetParameterBlockConstant(graph.poses[i].data());
  }
  ceres::Solver::Summary report;
  ceres::Solve(solver_options(params), &problem, &report);
  summary.iterations = report.num_successful_steps + report.num_unsuccessful_steps;
  summary.converged = report.termination_type == ceres::CONVERGENCE;
  summary.message = report.message;
}

}  // namespace falko_slam
