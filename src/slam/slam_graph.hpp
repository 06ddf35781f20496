// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/place_recognition/keyframe_file.hpp"
#include "falko_slam/pose_graph/consistency.hpp"
#include "falko_slam/pose_graph/optimizer.hpp"
#include "falko_slam/slam/nearby_keyframes.hpp"
#include "falko_slam/slam/slam_params.hpp"

namespace falko_slam {

/// The keyframes' poses and what was measured between them: the optimiser, the gates before it, and
/// the drives that still wait for their place in the map, each in a frame of its own.
class SlamGraph {
 public:
  SlamGraph(const SlamGraphParams& params, const NearbyKeyframesParams& nearby,
            const ConsistencyParams& consistency, const OptimizerParams& optimizer);
  /// Starts from a graph whose nodes are numbered from 0; all of it is mapped.
  void load(const PoseGraph& graph, const std::vector<KeyframeRecord>& keyframes);

  /// The first keyframe of a drive: mapped if it is the first one of all.
  KeyframeId begin_drive(const Pose2& pose, bool all_around);
  /// The next one, seen from the last.
  KeyframeId add_step(const PoseEstimate& last_T_keyframe, bool all_around);

  /// What the scans of keyframes of one drive that follow each other say.
  void add(const GraphConstraint& constraint);
  /// A closure that needs no gate: of keyframes that the graph knows to be near. Counts as a
  /// proposal.
  void admit(const GraphConstraint& closure);

  struct Verdict {
    std::size_t proposal;  // counted from 0 as they were made
    bool accepted;
    const char* reason;
  };
  /// A closure that may be false. Returns what became of it, and of others by it.
  std::vector<Verdict> propose(const GraphConstraint& closure);

  /// Keyframes that are surely near, of the same connected part.
  std::vector<NearbyKeyframe> nearby(KeyframeId source) { return nearby_.find(source, poses_); }

  /// Length of the way from one keyframe to a later one [m]; very long between drives.
  double way_between(KeyframeId a, KeyframeId b) const { return nearby_.path(b) - nearby_.path(a); }

  /// See NearbyKeyframes::drifts().
  std::vector<double> drifts(KeyframeId source) { return nearby_.drifts(source, poses_); }

  /// Optimises if a closure says that it is urgent, or if there is reason to and it was long ago.
  bool optimize_if_due();
  /// Optimises now.
  void update();

  /// Takes out the closures that the poses contradict, far off and farther than by chance. Returns
  /// their proposals.
  std::vector<std::size_t> drop_contradicted();

  const std::vector<Pose2>& poses() const { return poses_; }
  bool is_mapped(KeyframeId id) const { return drives_[drive_of_.at(id.value)].mapped; }
  PoseGraph graph() const { return optimizer_.graph(); }

 private:
  struct Proposal {
    GraphConstraint constraint;
    std::optional<std::size_t> in_graph;  // number in the optimiser
    bool in_force;
  };
  struct Waiting {
    GraphConstraint constraint;
    std::optional<std::size_t> proposal;
  };
  struct Anchor {
    std::size_t proposal;
    KeyframeId source;
    Pose2 map_T_drive;
  };
  struct Drive {
    std::size_t first;  // keyframe
    bool mapped;
    std::vector<Waiting> waiting;
    std::vector<Anchor> anchors;
  };

  void append(const Pose2& pose, double path, bool all_around);
  Drive& drive_of(KeyframeId id) { return drives_[drive_of_[id.value]]; }
  bool contradicts(const GraphConstraint& constraint, double distance, double turn) const;
  std::size_t put_in_force(const GraphConstraint& constraint);  // its number
  void accept(std::size_t proposal);
  void refuse(std::size_t proposal);
  bool against_graph(const GraphConstraint& closure);
  std::vector<Verdict> select(std::size_t proposal);
  std::vector<Verdict> anchor_by(std::size_t proposal);
  void map_drive(std::size_t drive, const Pose2& map_T_drive);
  void select_step(std::size_t keyframe);
  void take_poses();

  SlamGraphParams params_;
  NearbyKeyframes nearby_;
  ClosureSelection selection_;
  PoseGraphOptimizer optimizer_;
  std::vector<Drive> drives_;
  std::vector<std::size_t> drive_of_;  // each keyframe
  std::vector<Pose2> poses_;
  std::vector<PoseEstimate> steps_;  // to each keyframe from the one before, if of one drive
  std::vector<Proposal> proposals_;
  std::vector<std::size_t> selected_;  // proposals by their number in the selection
  std::optional<std::size_t> last_selected_step_;
  bool urgent_ = false;
  bool changed_ = false;
  int since_optimized_ = 0;
};

}  // namespace falko_slam
