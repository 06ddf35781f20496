// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/consistency.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "chi_square.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/matching/maximum_clique.hpp"
#include "node_index.hpp"
#include "odometry_chain.hpp"

namespace falko_slam {
namespace {

constexpr std::uint64_t kMaxSearchNodes = 100000;  // some tenths of a second

struct Closure {
  std::size_t a, b;            // in the chain
  Pose2 correction;            // D
  Eigen::Matrix3d covariance;  // of z, seen from the first node of the chain
  bool odometry_tells = false;
  bool possible = false;              // passed alone
  bool kept = false;                  // belongs to the largest set
  std::vector<std::size_t> against;   // those it contradicts
  std::vector<std::size_t> confirms;  // those it agrees with, and that could be seen if it did not
  ClosureVerdict verdict = ClosureVerdict::kAgainstOdometry;
};

double squared_distance(const Pose2& left, const Eigen::Matrix3d& covariance) {
  const Eigen::Vector3d error = left.log();
  return error.dot(covariance.ldlt().solve(error));
}

}  // namespace

void validate(const ConsistencyParams& params) {
  require_in_range("gate_probability", params.gate_probability, 0.5, 0.999999);
  require_in_range("trusted_chance", params.trusted_chance, 0.0, 1.0);
  require_in_range("confirmations", params.confirmations, 1, 100);
}

const char* name_of(ClosureVerdict verdict) {
  switch (verdict) {
    case ClosureVerdict::kAccepted:
      return "accepted";
    case ClosureVerdict::kPending:
      return "pending";
    case ClosureVerdict::kAgainstOdometry:
      return "against_odometry";
    case ClosureVerdict::kAgainstOtherClosures:
      return "against_other_closures";
  }
  return "?";
}

struct ClosureSelection::State {
  ConsistencyParams params;
  double gate = 0.0;
  NodeIndex index;
  OdometryChain chain;
  std::vector<Closure> closures;
  MaximumClique clique;

  // Volume of the gate's ellipsoid in (x, y, theta) over that of all poses where it drove.
  bool is_trusted(const Eigen::Matrix3d& covariance) const {
    const double gate_volume =
        4.0 / 3.0 * kPi * std::pow(gate, 1.5) * std::sqrt(std::max(covariance.determinant(), 0.0));
    return gate_volume <= params.trusted_chance * kTwoPi * chain.area();
  }

  Closure judge_alone(const GraphConstraint& constraint) const {
    Closure closure;
    closure.a = index.at(constraint.from);
    closure.b = index.at(constraint.to);
    const Pose2 first_T_to = chain.pose(closure.a) * constraint.from_T_to;
    closure.correction = first_T_to * chain.pose(closure.b).inverse();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = constraint.from_T_to.rotation().transpose();
    closure.covariance =
        moved(first_T_to, turn * estimate_of(constraint).covariance * turn.transpose());
    const Eigen::Matrix3d drift = chain.covariance({closure.a, closure.b});
    closure.odometry_tells = is_trusted(drift + closure.covariance);
    closure.possible = squared_distance(closure.correction, drift + closure.covariance) <= gate;
    return closure;
  }

  // Tests the new closure, not yet in the list, against all others.
  void compare(Closure& added) {
    for (std::size_t other = 0; other < closures.size(); ++other) {
      Closure& old = closures[other];
      if (!old.possible) continue;
      const Eigen::Matrix3d drift =
          chain.covariance({added.a, old.a}, {old.b, added.b}, old.correction);
      const Pose2 left = old.correction * added.correction.inverse();
      const Eigen::Matrix3d covariance = drift + added.covariance + old.covariance;
      if (squared_distance(left, covariance) > gate) {
        added.against.push_back(other);
        old.against.push_back(closures.size());
      } else if (!(added.odometry_tells && old.odometry_tells) && is_trusted(covariance)) {
        added.confirms.push_back(other);
        old.confirms.push_back(closures.size());
      }
    }
  }

  // All that hang together with a closure by contradictions, without it.
  std::vector<std::size_t> quarrel_of(std::size_t closure) const {
    std::vector<bool> seen(closures.size(), false);
    seen[closure] = true;
    std::vector<std::size_t> found{closure};
    for (std::size_t at = 0; at < found.size(); ++at) {
      for (const std::size_t next : closures[found[at]].against) {
        if (!seen[next]) found.push_back(next);
        seen[next] = true;
      }
    }
    found.erase(found.begin());
    return found;
  }

  // Before the closure came, the largest set of each quarrel was kept. A larger one holds it.
  void settle(std::size_t added) {
    const std::vector<std::size_t> quarrel = quarrel_of(added);
    std::vector<bool> contradicts(closures.size(), false);
    for (const std::size_t other : closures[added].against) contradicts[other] = true;
    std::size_t kept = 0;
    std::vector<std::size_t> friends;
    for (const std::size_t other : quarrel) {
      if (closures[other].kept) ++kept;
      if (!contradicts[other]) friends.push_back(other);
    }
    if (friends.size() < kept) return;
    if (kept > 0) {
      const std::vector<std::size_t> largest = largest_set(friends, kept - 1);
      if (largest.size() < kept) return;
      for (const std::size_t other : quarrel) closures[other].kept = false;
      for (const std::size_t other : largest) closures[other].kept = true;
    }
    closures[added].kept = true;
  }

  std::vector<std::size_t> largest_set(const std::vector<std::size_t>& of,
                                       std::size_t larger_than) {
    std::vector<std::size_t> number(closures.size(), of.size());
    for (std::size_t i = 0; i < of.size(); ++i) number[of[i]] = i;
    BitGraph graph(of.size());
    for (std::size_t i = 0; i < of.size(); ++i) {
      std::vector<bool> contradicts(of.size() + 1, false);
      for (const std::size_t other : closures[of[i]].against) contradicts[number[other]] = true;
      for (std::size_t j = 0; j < i; ++j) {
        if (!contradicts[j]) graph.add_edge(i, j);
      }
    }
    std::vector<std::size_t> result;
    const CliqueResult found = clique.search(graph, {larger_than, kMaxSearchNodes});
    for (const std::size_t vertex : found.vertices) result.push_back(of[vertex]);
    return result;
  }

  ClosureVerdict verdict_of(const Closure& closure) const {
    if (!closure.possible) return ClosureVerdict::kAgainstOdometry;
    if (!closure.kept) return ClosureVerdict::kAgainstOtherClosures;
    if (closure.odometry_tells) return ClosureVerdict::kAccepted;
    const auto confirmed =
        1 + std::count_if(closure.confirms.begin(), closure.confirms.end(),
                          [this](std::size_t other) { return closures[other].kept; });
    return confirmed >= params.confirmations ? ClosureVerdict::kAccepted : ClosureVerdict::kPending;
  }
};

ClosureSelection::ClosureSelection(const ConsistencyParams& params)
    : state_(std::make_unique<State>()) {
  validate(params);
  state_->params = params;
  state_->gate = chi_square_quantile_3(params.gate_probability);
}

ClosureSelection::~ClosureSelection() = default;
ClosureSelection::ClosureSelection(ClosureSelection&&) noexcept = default;
ClosureSelection& ClosureSelection::operator=(ClosureSelection&&) noexcept = default;

void ClosureSelection::add_step(KeyframeId node, const PoseEstimate& last_T_node) {
  const Pose2& pose = last_T_node.pose;
  if (!pose.translation().allFinite() || !std::isfinite(pose.theta()) ||
      !last_T_node.covariance.allFinite()) {
    throw std::invalid_argument("step to node " + std::to_string(node.value) + ": is not finite");
  }
  state_->index.add(node);
  state_->chain.add(last_T_node);
}

std::vector<ClosureSelection::Change> ClosureSelection::add_closure(
    const GraphConstraint& closure) {
  const std::size_t number = state_->closures.size();
  Closure added = state_->judge_alone(closure);
  if (added.possible) state_->compare(added);
  state_->closures.push_back(std::move(added));
  if (state_->closures[number].possible) state_->settle(number);
  std::vector<Change> changes;
  for (std::size_t i = 0; i <= number; ++i) {
    const ClosureVerdict now = state_->verdict_of(state_->closures[i]);
    if (i == number || now != state_->closures[i].verdict) changes.push_back({i, now});
    state_->closures[i].verdict = now;
  }
  return changes;
}

ClosureVerdict ClosureSelection::verdict(std::size_t closure) const {
  return state_->closures.at(closure).verdict;
}

std::vector<ClosureVerdict> select_closures(const PoseGraph& graph,
                                            const ConsistencyParams& params) {
  const NodeIndex index(graph.nodes);
  std::vector<const GraphConstraint*> step_to(graph.nodes.size(), nullptr);
  for (const GraphConstraint& constraint : graph.constraints) {
    const std::size_t from = index.at(constraint.from), to = index.at(constraint.to);
    const std::size_t last = std::max(from, to);
    if (constraint.kind == ConstraintKind::kClosure || last - std::min(from, to) != 1) continue;
    if (step_to[last] == nullptr) step_to[last] = &constraint;
  }
  ClosureSelection selection(params);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    if (i > 0 && step_to[i] == nullptr) {
      throw std::invalid_argument("node " + std::to_string(graph.nodes[i].id.value) +
                                  ": no odometry joins it to the one before");
    }
    PoseEstimate step;
    if (i > 0) step = estimate_of(*step_to[i]);
    if (i > 0 && index.at(step_to[i]->from) == i) step = inverse(step);
    selection.add_step(graph.nodes[i].id, step);
  }
  std::vector<ClosureVerdict> verdicts(graph.constraints.size(), ClosureVerdict::kAccepted);
  std::vector<std::size_t> closures;
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    if (graph.constraints[i].kind != ConstraintKind::kClosure) continue;
    selection.add_closure(graph.constraints[i]);
    closures.push_back(i);
  }
  for (std::size_t k = 0; k < closures.size(); ++k) verdicts[closures[k]] = selection.verdict(k);
  return verdicts;
}

}  // namespace falko_slam
