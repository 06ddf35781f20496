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
  if (drive_of_[closure.from.value] == drive_of_[closure.to.value] && !is_mapped(closure.to) &&
      !against_graph(closure)) {
    admit(closure);
    return {{proposal, true, "accepted"}};
  }
  proposals_.push_back({closure, {}, false});
  if (drive_of_[closure.from.value] != drive_of_[closure.to.value] &&
      !(is_mapped(closure.from) && is_mapped(closure.to))) {
    return anchor_by(proposal);
  }
  if (against_graph(closure)) return {{proposal, false, "against_graph"}};
  return select(proposal);
}

void SlamGraph::admit(const GraphConstraint& closure) {
  const std::size_t proposal = proposals_.size();
  proposals_.push_back({closure, {}, true});
  nearby_.connect(closure.from, closure.to, estimate_of(closure).covariance);
  Drive& drive = drive_of(closure.to);
  if (drive.mapped) {
    proposals_[proposal].in_graph = put_in_force(closure);
  } else {
    drive.waiting.push_back({closure, proposal});
  }
}

void SlamGraph::accept(std::size_t proposal) {
  Proposal& accepted = proposals_[proposal];
  accepted.in_force = true;
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
  proposals_[proposal].in_force = false;
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

std::vector<std::size_t> SlamGraph::drop_contradicted() {
  constexpr double kWrong = 0.3;                               // [m]
  constexpr double kWronglyTurned = degrees_to_radians(10.0);  // [rad]
  std::vector<std::size_t> dropped;
  for (std::size_t i = 0; i < proposals_.size(); ++i) {
    const Proposal& proposal = proposals_[i];
    if (!proposal.in_force || !proposal.in_graph) continue;
    if (!contradicts(proposal.constraint, kWrong, kWronglyTurned)) continue;
    refuse(i);
    dropped.push_back(i);
  }
  return dropped;
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
  for (const Waiting& waiting : drive.waiting) {
    const std::size_t in_graph = optimizer_.add_constraint(waiting.constraint);
    if (waiting.proposal) proposals_[*waiting.proposal].in_graph = in_graph;
  }
  drive.waiting.clear();
}

// The selection knows one chain, in the order in which drives were mapped.
void SlamGraph::select_step(std::size_t keyframe) {
  PoseEstimate step = steps_[keyframe];
  const std::size_t last = last_selected_step_.value_or(keyframe);
  if (last + 1 != keyframe || drive_of_[last] != drive_of_[keyframe]) {
    step.pose = poses_[last].inverse() * poses_[keyframe];
    step.covariance = pose_covariance(kAnchoredDistance, kAnchoredTurn);
  }
  selection_.add_step({keyframe}, step);
  last_selected_step_ = keyframe;
}

}  // namespace falko_slam
