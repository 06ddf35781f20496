// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "feature_slam_impl.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace falko_slam {
namespace {

// How well poses are known before scans are linked: the registration's prior. [m], [rad]
constexpr double kNeighborDistance = 0.05;
constexpr double kNeighborTurn = 0.03;
constexpr double kNearbyTurn = 0.10;
// A place farther from where the graph puts it than this, and than so many times what the graph may
// have drifted, is another one. [m]
constexpr double kLeastReach = 1.0;
constexpr double kManyDrifts = 4.0;
// A place that is known no better than this in some direction closes no loop: in a corridor without
// an end any stretch is as good as another. [m]
constexpr double kLongestDeviation = 0.5;
constexpr double kPlaceDistance = 0.10;
constexpr double kPlaceTurn = 0.05;

// Standard deviation of the position in the direction in which it is least known [m].
double longest_deviation(const PoseEstimate& estimate) {
  const Eigen::Matrix2d place = estimate.covariance.topLeftCorner<2, 2>();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(place).eigenvalues().y());
}

// The tracker has mended the steps already.
LoopClosureParams memory_params(const SlamParams& params) {
  LoopClosureParams result;
  result.scan = params.scan;
  result.detector = params.loops;
  result.detector.odometry.max_move = 0.0;
  return result;
}

Eigen::Matrix3d covariance_of_base(const Pose2& map_T_keyframe, const TrackedScan& tracked,
                                   const Pose2& base_T_laser) {
  const PoseEstimate map_T_laser = compose({map_T_keyframe}, tracked.keyframe_T_laser);
  return compose(map_T_laser, {base_T_laser.inverse()}).covariance;
}

const SlamState& checked(const SlamState& state) {
  if (state.graph.nodes.size() != state.keyframes.size()) {
    throw std::invalid_argument("SLAM state: " + std::to_string(state.keyframes.size()) +
                                " keyframes, but " + std::to_string(state.graph.nodes.size()) +
                                " poses");
  }
  for (std::size_t i = 0; i < state.graph.nodes.size(); ++i) {
    if (state.graph.nodes[i].id.value == i) continue;
    throw std::invalid_argument("SLAM state: pose " + std::to_string(i) + " is of keyframe " +
                                std::to_string(state.graph.nodes[i].id.value));
  }
  return state;
}

}  // namespace

FeatureSlam::Impl::Impl(const SlamParams& p, const SlamState& state)
    : params(p),
      tracker(p.tracker, p.loops.keyframe, p.loops.agreement),
      memory(memory_params(p), checked(state).keyframes),
      graph(p.graph, p.nearby, p.consistency, p.optimizer) {
  graph.load(state.graph, state.keyframes);
}

void FeatureSlam::Impl::begin_drive() {
  tracker.reset();
  motion.reset();
  memory.begin_drive();
  new_drive = true;
}

SlamStep FeatureSlam::Impl::add(const SlamScan& taken) {
  enter(SlamStage::kTracking);
  std::optional<Pose2> odom_T_laser;
  if (taken.odom_T_base) odom_T_laser = *taken.odom_T_base * taken.base_T_laser;
  SlamScan scan = taken;
  if (params.deskew) scan.scan = motion.apply(taken.scan, taken.stamp, odom_T_laser);
  TrackedScan tracked = tracker.track(scan.scan, scan.stamp, odom_T_laser);
  motion.found(tracked.track_T_laser);
  SlamStep step;
  step.lost = tracked.lost;
  step.searched = tracked.searched;
  step.agreement = tracked.agreement;
  step.is_keyframe = tracked.keyframe;
  const Pose2 map_T_last = graph.poses().empty() ? Pose2() : graph.poses().back();
  step.covariance = covariance_of_base(map_T_last, tracked, scan.base_T_laser);
  if (tracked.keyframe) {
    const KeyframeId id = add_keyframe(scan, tracked);
    tracked.keyframe_T_laser.pose = Pose2();
    link_with_neighbors(id);
    if (!link_with_nearby(id)) close_loops(id);
    enter(SlamStage::kOptimization);
    step.optimized = graph.optimize_if_due();
  }
  enter(SlamStage::kIdle);
  if (new_drive) {
    step.map_T_base = scan.odom_T_base.value_or(Pose2());
    return step;
  }
  step.keyframe = KeyframeId{graph.poses().size() - 1};
  step.keyframe_T_base = tracked.keyframe_T_laser.pose * scan.base_T_laser.inverse();
  step.map_T_base = graph.poses().back() * step.keyframe_T_base;
  step.anchored = graph.is_mapped(*step.keyframe);
  return step;
}

KeyframeId FeatureSlam::Impl::add_keyframe(const SlamScan& scan, const TrackedScan& tracked) {
  enter(SlamStage::kKeyframe);
  tracker.keep(scan.scan);
  KeyframeRecord record;
  record.stamp = scan.stamp;
  record.odom_T_laser = tracked.track_T_laser;
  record.base_T_laser = scan.base_T_laser;
  record.scan = scan.scan;
  const bool all_around = scan.scan.closed;
  memory.add(std::move(record));
  if (!new_drive) return graph.add_step(tracked.keyframe_T_laser, all_around);
  new_drive = false;
  // Without odometry the map begins with base_link, not with the laser.
  const Pose2 first = scan.odom_T_base ? tracked.track_T_laser : scan.base_T_laser;
  return graph.begin_drive(first, all_around);
}

void FeatureSlam::Impl::link_with_neighbors(KeyframeId id) {
  enter(SlamStage::kLinks);
  const std::vector<Pose2>& poses = graph.poses();
  const std::size_t drive = memory.record(id).drive;
  for (int back = 1; back <= params.graph.neighbors; ++back) {
    if (id.value < static_cast<std::size_t>(back)) return;
    const KeyframeId other{id.value - static_cast<std::size_t>(back)};
    if (memory.record(other).drive != drive) return;
    const Pose2 expected = poses[other.value].inverse() * poses[id.value];
    const auto link = link_scans(view(other), view(id),
                                 {expected, pose_covariance(kNeighborDistance, kNeighborTurn)},
                                 params.link, params.loops.agreement);
    if (!link) continue;
    graph.add(constraint_between(other, id, link->target_T_source, ConstraintKind::kRegistration));
  }
}

// Whether a place of long ago is among them: then there is no need to search for one.
bool FeatureSlam::Impl::link_with_nearby(KeyframeId id) {
  bool revisited = false;
  for (const auto& [other, drift] : graph.nearby(id)) {
    const std::vector<Pose2>& poses = graph.poses();
    const Pose2 expected = poses[other.value].inverse() * poses[id.value];
    const auto link =
        link_scans(view(other), view(id),
                   {expected, pose_covariance(std::max(kNeighborDistance, drift), kNearbyTurn)},
                   params.link, params.loops.agreement);
    if (!link) continue;
    graph.admit(constraint_between(other, id, link->target_T_source, ConstraintKind::kClosure));
    proposed.push_back(closures.size());
    closures.push_back({memory.record(id).stamp, id, other, link->target_T_source.pose,
                        ClosureOrigin::kNearby, link->agreement, true, "accepted"});
    revisited = revisited || graph.way_between(other, id) >= params.loops.min_path;
  }
  return revisited;
}

void FeatureSlam::Impl::close_loops(KeyframeId id) {
  enter(SlamStage::kLoops);
  const std::vector<double> drifts = graph.drifts(id);
  const std::vector<Pose2>& poses = graph.poses();
  const auto possible = [&](const Keyframe& target, const Pose2& target_T_source) {
    const Pose2 here = poses[target.id.value] * target_T_source;
    return (here.translation() - poses[id.value].translation()).norm() <=
           kLeastReach + kManyDrifts * drifts[target.id.value];
  };
  const LoopDetection detection = memory.detect(id, possible);
  const LoopCandidate* best = detection.accepted();
  if (best == nullptr) {
    if (detection.candidates.empty() || detection.candidates.front().scan_score <= 0.0) return;
    const LoopCandidate& refused = detection.candidates.front();
    closures.push_back({memory.record(id).stamp, id, refused.target, refused.target_T_source->pose,
                        ClosureOrigin::kPlace, refused.score, false, name_of(refused.verdict)});
    return;
  }
  SlamClosure closure{
      memory.record(id).stamp, id,         best->target, best->target_T_source->pose,
      ClosureOrigin::kPlace,   best->score};
  const auto link =
      link_scans(view(best->target), view(id),
                 {closure.target_T_source, pose_covariance(kPlaceDistance, kPlaceTurn)},
                 params.link, params.loops.agreement);
  if (!link) {
    closure.verdict = "scans_do_not_agree";
    closures.push_back(closure);
    return;
  }
  closure.target_T_source = link->target_T_source.pose;
  if (longest_deviation(link->target_T_source) > kLongestDeviation) {
    closure.verdict = "leaves_a_direction_open";
    closures.push_back(closure);
    return;
  }
  propose(closure, link->target_T_source);
}

void FeatureSlam::Impl::propose(SlamClosure closure, const PoseEstimate& target_T_source) {
  proposed.push_back(closures.size());
  closures.push_back(std::move(closure));
  const SlamClosure& added = closures.back();
  const auto verdicts = graph.propose(
      constraint_between(added.target, added.source, target_T_source, ConstraintKind::kClosure));
  for (const SlamGraph::Verdict& verdict : verdicts) {
    SlamClosure& changed = closures[proposed[verdict.proposal]];
    changed.accepted = verdict.accepted;
    changed.verdict = verdict.reason;
  }
}

// The loss has made a false closure weak; that it is false can be told from the finished map.
void FeatureSlam::Impl::finish() {
  enter(SlamStage::kOptimization);
  graph.update();
  const std::vector<std::size_t> dropped = graph.drop_contradicted();
  for (const std::size_t proposal : dropped) {
    closures[proposed[proposal]].accepted = false;
    closures[proposed[proposal]].verdict = "against_map";
  }
  if (!dropped.empty()) graph.update();
  enter(SlamStage::kIdle);
}

SlamState FeatureSlam::Impl::state() const {
  PoseGraph mapped = graph.graph();
  std::sort(mapped.nodes.begin(), mapped.nodes.end(),
            [](const GraphNode& a, const GraphNode& b) { return a.id < b.id; });
  SlamState result;
  std::vector<KeyframeId> renumbered(graph.poses().size());
  std::vector<std::size_t> drives;  // as they were
  std::size_t number = 0;           // of the drive now
  for (GraphNode node : mapped.nodes) {
    const KeyframeId id{result.keyframes.size()};
    result.keyframes.push_back(memory.record(node.id));
    const std::size_t drive = result.keyframes.back().drive;
    if (!drives.empty() && drives.back() != drive) ++number;
    drives.push_back(drive);
    result.keyframes.back().drive = number;
    renumbered[node.id.value] = id;
    node.id = id;
    result.graph.nodes.push_back(node);
  }
  for (GraphConstraint constraint : mapped.constraints) {
    constraint.from = renumbered[constraint.from.value];
    constraint.to = renumbered[constraint.to.value];
    result.graph.constraints.push_back(constraint);
  }
  for (const KeyframeId id : mapped.fixed) result.graph.fixed.push_back(renumbered[id.value]);
  return result;
}

}  // namespace falko_slam
