// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "slam_graph.hpp"

namespace falko_slam {
namespace {

// A closure contradicts the graph if it is off by more than this, and by more than the graph may
// be.
constexpr double kFarOff = 1.0;      // [m]
constexpr double kFarTurned = 0.35;  // [rad]
constexpr double kCertain = 0.15;    // of the graph, one standard deviation [m]
constexpr double kManyDeviations = 6.0;

// How well an anchored drive is placed beside the one before it: as well as its anchors. [m], [rad]
constexpr double kAnchoredDistance = 1.0;
constexpr double kAnchoredTurn = 0.2;

}  // namespace

// Where the graph is certain of both keyframes, a closure far from what it says is false.
bool SlamGraph::against_graph(const GraphConstraint& closure) {
  const auto drift = nearby_.drift(closure.from, closure.to, poses_, kCertain);
  if (!drift) return false;
  const Pose2& from = poses_[closure.from.value];
  const Pose2& to = poses_[closure.to.value];
  const Eigen::Vector3d residual = residual_of(closure, from, to);
  return residual.head<2>().norm() > kFarOff + kManyDeviations * *drift ||
         std::abs(residual.z()) > kFarTurned;
}

std::vector<SlamGraph::Verdict> SlamGraph::propose(const GraphConstraint& closure) {
  const std::size_t proposal = proposals_.size();
  proposals_.push_back({closure, {}});
  if (drive_of_[closure.from.value] != drive_of_[closure.to.value] &&
      !(is_mapped(closure.from) && is_mapped(closure.to))) {
    return anchor_by(proposal);
  }
  if (against_graph(closure)) return {{proposal, false, "against_graph"}};
  if (is_mapped(closure.to)) return select(proposal);
  add(closure);
  return {{proposal, true, "accepted"}};
}

void SlamGraph::accept(std::size_t proposal) {
  Proposal& accepted = proposals_[proposal];
  if (accepted.in_graph) {
    optimizer_.set_in_force(*accepted.in_graph, true);
    changed_ = urgent_ = true;
    return;
  }
  const GraphConstraint& constraint = accepted.constraint;
  accepted.in_graph = put_in_force(constraint);
  nearby_.connect(constraint.from, constraint.to, estimate_of(constraint).covariance);
}

void SlamGraph::refuse(std::size_t proposal) {
  if (!proposals_[proposal].in_graph) return;
  optimizer_.set_in_force(*proposals_[proposal].in_graph, false);
  changed_ = urgent_ = true;
}

std::vector<SlamGraph::Verdict> SlamGraph::select(std::size_t proposal) {
  std::vector<Verdict> verdicts;
  selected_.push_back(proposal);
  for (const auto& change : selection_.add_closure(proposals_[proposal].constraint)) {
    const std::size_t changed = selected_[change.closure];
    const bool accepted = change.verdict == ClosureVerdict::kAccepted;
    accepted ? accept(changed) : refuse(changed);
    verdicts.push_back({changed, accepted, name_of(change.verdict)});
  }
  return verdicts;
}

bool SlamGraph::drop_if_contradicted(std::size_t number, const GraphConstraint& constraint) {
  constexpr double kWrong = 0.3;                               // [m]
  constexpr double kWronglyTurned = degrees_to_radians(10.0);  // [rad]
  constexpr double kSignificant = 16.27;  // chi2 of three degrees of freedom, 99.9 %
  const Pose2& from = poses_[constraint.from.value];
  const Pose2& to = poses_[constraint.to.value];
  const Eigen::Vector3d residual = residual_of(constraint, from, to);
  const bool wrong =
      residual.head<2>().norm() >= kWrong || std::abs(residual.z()) >= kWronglyTurned;
  if (!wrong || chi2_of(constraint, from, to) <= kSignificant) return false;
  optimizer_.set_in_force(number, false);
  return true;
}

// Two closures of different keyframes that put a drive at the same place anchor it there.
std::vector<SlamGraph::Verdict> SlamGraph::anchor_by(std::size_t proposal) {
  const GraphConstraint& closure = proposals_[proposal].constraint;
  if (!is_mapped(closure.from) && !is_mapped(closure.to)) return {{proposal, false, "pending"}};
  const bool forward = is_mapped(closure.from);
  const KeyframeId known = forward ? closure.from : closure.to;
  const KeyframeId source = forward ? closure.to : closure.from;
  const Pose2 known_T_source = forward ? closure.from_T_to : closure.from_T_to.inverse();
  const Pose2& here = poses_[source.value];
  const Pose2 map_T_drive = poses_[known.value] * known_T_source * here.inverse();
  Drive& drive = drive_of(source);
  std::vector<std::size_t> agreeing;
  for (const Anchor& other : drive.anchors) {
    const Pose2 difference = (other.map_T_drive * here).inverse() * (map_T_drive * here);
    if (other.source != source && difference.translation().norm() <= params_.anchor_distance &&
        std::abs(difference.theta()) <= params_.anchor_turn) {
      agreeing.push_back(other.proposal);
    }
  }
  drive.anchors.push_back({proposal, source, map_T_drive});
  if (agreeing.empty()) return {{proposal, false, "pending"}};
  map_drive(drive_of_[source.value], map_T_drive);
  agreeing.push_back(proposal);
  std::vector<Verdict> verdicts;
  for (const std::size_t each : agreeing) {
    accept(each);
    verdicts.push_back({each, true, "accepted"});
  }
  urgent_ = true;
  return verdicts;
}

void SlamGraph::map_drive(std::size_t number, const Pose2& map_T_drive) {
  Drive& drive = drives_[number];
  drive.mapped = true;
  for (std::size_t i = drive.first; i < poses_.size() && drive_of_[i] == number; ++i) {
    poses_[i] = map_T_drive * poses_[i];
    optimizer_.add_node({{i}, poses_[i]});
    select_step(i);
  }
  for (const GraphConstraint& constraint : drive.waiting) optimizer_.add_constraint(constraint);
  drive.waiting.clear();
}

// The selection knows one chain, in the order in which drives were mapped.
void SlamGraph::select_step(std::size_t keyframe) {
  PoseEstimate step = steps_[keyframe];
  const std::size_t last = last_selected_step_.value_or(keyframe);
  if (last + 1 != keyframe || drive_of_[last] != drive_of_[keyframe]) {
    step.pose = poses_[last].inverse() * poses_[keyframe];
    step.covariance =
        Eigen::Vector3d(kAnchoredDistance * kAnchoredDistance,
                        kAnchoredDistance * kAnchoredDistance, kAnchoredTurn * kAnchoredTurn)
            .asDiagonal();
  }
  selection_.add_step({keyframe}, step);
  last_selected_step_ = keyframe;
}

}  // namespace falko_slam
