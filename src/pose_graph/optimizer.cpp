// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/optimizer.hpp"

#include <stdexcept>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "graph_problem.hpp"
#include "incremental_solver.hpp"
#include "linear_graph.hpp"
#include "node_index.hpp"

namespace falko_slam {
namespace {

Eigen::Vector3d coordinates_of(const Pose2& pose) { return {pose.x(), pose.y(), pose.theta()}; }
Pose2 pose_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::string name_of(const GraphConstraint& constraint) {
  return "constraint of nodes " + std::to_string(constraint.from.value) + " and " +
         std::to_string(constraint.to.value);
}

RelativePoseFactor factor_of(const GraphConstraint& constraint) {
  if (!coordinates_of(constraint.from_T_to).allFinite()) {
    throw std::invalid_argument(name_of(constraint) + ": the pose is not finite");
  }
  if (constraint.from == constraint.to) {
    throw std::invalid_argument(name_of(constraint) + ": must be two different ones");
  }
  try {
    return RelativePoseFactor(constraint);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name_of(constraint) + ": " + error.what());
  }
}

}  // namespace

void validate(const OptimizerParams& params) {
  require_in_range("loss_scale", params.loss_scale, 0.01, 1000.0);
  require_in_range("max_iterations", params.max_iterations, 1, 10000);
}

struct PoseGraphOptimizer::State {
  OptimizerParams params;
  NodeIndex index;
  std::vector<KeyframeId> ids;
  std::vector<GraphConstraint> constraints;  // of the factors with the same numbers
  GraphProblem problem;
  IncrementalSolver incremental;
  std::size_t updated_factors = 0;  // how many there were in the last update

  // A true closure after a long drive lies so far out on the tail of its loss that it hardly pulls.
  // The new ones first pull without it. False if that was for nothing, the poses as they were.
  bool update_with_loss_last(OptimizationSummary& summary) {
    const double c2 = params.loss_scale * params.loss_scale;
    std::vector<std::size_t> far;
    for (std::size_t i = updated_factors; i < problem.factors.size(); ++i) {
      const GraphFactor& f = problem.factors[i];
      if (!f.robust || !f.in_force) continue;
      const Eigen::Vector3d left = f.factor.residual(problem.poses[f.from], problem.poses[f.to]);
      if (left.squaredNorm() > c2) far.push_back(i);
    }
    if (far.empty() || params.closure_loss == Loss::kNone) return false;
    const std::vector<Eigen::Vector3d> start = problem.poses;
    const double start_cost = evaluate_cost(problem, params).cost;
    OptimizationSummary pulled;
    for (const std::size_t i : far) problem.factors[i].robust = false;
    const bool moved = incremental.solve(problem, params, pulled, true);
    for (const std::size_t i : far) problem.factors[i].robust = true;
    const bool better = moved && incremental.solve(problem, params, summary) &&
                        evaluate_cost(problem, params).cost <= start_cost;
    summary.iterations += pulled.iterations;
    if (!better) problem.poses = start;
    return better;
  }

  template <class Solve>
  OptimizationSummary summarize(const Solve& solve) {
    OptimizationSummary summary;
    summary.initial_chi2 = evaluate_cost(problem, params).chi2;
    solve(summary);
    const GraphCost final = evaluate_cost(problem, params);
    summary.final_chi2 = final.chi2;
    summary.final_cost = final.cost;
    return summary;
  }
};

PoseGraphOptimizer::PoseGraphOptimizer(const OptimizerParams& params)
    : state_(std::make_unique<State>()) {
  validate(params);
  state_->params = params;
}

PoseGraphOptimizer::PoseGraphOptimizer(const PoseGraph& graph, const OptimizerParams& params)
    : PoseGraphOptimizer(params) {
  state_->constraints.reserve(graph.constraints.size());
  state_->problem.factors.reserve(graph.constraints.size());
  for (const GraphNode& node : graph.nodes) add_node(node);
  for (const GraphConstraint& constraint : graph.constraints) add_constraint(constraint);
  for (const KeyframeId id : graph.fixed) fix(id);
}

PoseGraphOptimizer::~PoseGraphOptimizer() = default;
PoseGraphOptimizer::PoseGraphOptimizer(PoseGraphOptimizer&&) noexcept = default;
PoseGraphOptimizer& PoseGraphOptimizer::operator=(PoseGraphOptimizer&&) noexcept = default;

void PoseGraphOptimizer::add_node(const GraphNode& node) {
  const Eigen::Vector3d coordinates = coordinates_of(node.map_T_node);
  if (!coordinates.allFinite()) {
    throw std::invalid_argument("node " + std::to_string(node.id.value) +
                                ": the pose is not finite");
  }
  state_->index.add(node.id);
  state_->ids.push_back(node.id);
  state_->problem.poses.push_back(coordinates);
  state_->problem.fixed.push_back(false);
}

std::size_t PoseGraphOptimizer::add_constraint(const GraphConstraint& constraint) {
  state_->problem.factors.push_back({state_->index.at(constraint.from),
                                     state_->index.at(constraint.to), factor_of(constraint),
                                     constraint.kind != ConstraintKind::kOdometry});
  state_->constraints.push_back(constraint);
  return state_->constraints.size() - 1;
}

void PoseGraphOptimizer::set_in_force(std::size_t constraint, bool in_force) {
  if (constraint >= state_->constraints.size()) {
    throw std::invalid_argument("constraint " + std::to_string(constraint) +
                                ": is not in the graph");
  }
  state_->problem.factors[constraint].in_force = in_force;
}

void PoseGraphOptimizer::fix(KeyframeId node) {
  state_->problem.fixed[state_->index.at(node)] = true;
}

OptimizationSummary PoseGraphOptimizer::optimize() {
  return state_->summarize([this](OptimizationSummary& summary) {
    solve_with_ceres(state_->problem, state_->params, summary);
  });
}

OptimizationSummary PoseGraphOptimizer::update() {
  return state_->summarize([this](OptimizationSummary& summary) {
    const bool updated = state_->update_with_loss_last(summary) ||
                         state_->incremental.solve(state_->problem, state_->params, summary);
    if (!updated) solve_with_ceres(state_->problem, state_->params, summary);
    state_->updated_factors = state_->problem.factors.size();
  });
}

Pose2 PoseGraphOptimizer::pose(KeyframeId node) const {
  return pose_of(state_->problem.poses[state_->index.at(node)]);
}

PoseGraph PoseGraphOptimizer::graph() const {
  PoseGraph graph;
  for (std::size_t i = 0; i < state_->ids.size(); ++i) {
    graph.nodes.push_back({state_->ids[i], pose_of(state_->problem.poses[i])});
    if (state_->problem.fixed[i]) graph.fixed.push_back(state_->ids[i]);
  }
  for (std::size_t i = 0; i < state_->constraints.size(); ++i) {
    if (state_->problem.factors[i].in_force) graph.constraints.push_back(state_->constraints[i]);
  }
  return graph;
}

std::optional<Eigen::Matrix3d> PoseGraphOptimizer::marginal_covariance(KeyframeId node) const {
  const std::size_t number = state_->index.at(node);
  const LinearGraph linear(state_->problem, state_->params);
  if (!linear.solvable()) return std::nullopt;
  return linear.covariance(number);
}

}  // namespace falko_slam
