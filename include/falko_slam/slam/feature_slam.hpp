// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/common/keyframe_id.hpp"
#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/place_recognition/keyframe_file.hpp"
#include "falko_slam/pose_graph/pose_graph.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/slam/slam_params.hpp"

namespace falko_slam {

/// A scan as SLAM takes it in.
struct SlamScan {
  Time stamp{};
  LaserScan scan;
  std::optional<Pose2> odom_T_base;  ///< at the stamp; empty if nothing tells
  Pose2 base_T_laser;
};

/// Where a closure comes from.
enum class ClosureOrigin {
  kNearby,    ///< the graph knows that both keyframes are near each other
  kPlace,     ///< recognised by the loop detector
  kProposed,  ///< from outside, see FeatureSlam::propose
};
const char* name_of(ClosureOrigin origin);

/// What became of a closure.
struct SlamClosure {
  Time stamp{};  ///< of the source's scan
  KeyframeId source;
  KeyframeId target;
  Pose2 target_T_source;  ///< of the lasers
  ClosureOrigin origin = ClosureOrigin::kPlace;
  double score = 0.0;               ///< agreement of the scans, or the loop detector's score
  bool accepted = false;            ///< is in the graph
  std::string verdict = "pending";  ///< "accepted", or why it is not
};

/// What a scan has done.
struct SlamStep {
  Pose2 map_T_base;  ///< now; while not anchored in a frame of the drive's own
  /// Of map_T_base's x, y [m] and theta [rad], seen from the newest keyframe before: by how much
  /// the map itself may be off is not in it.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// The newest one of the drive; empty as long as no scan has shown anything.
  std::optional<KeyframeId> keyframe;
  Pose2 keyframe_T_base;     ///< for good: the graph moves keyframes only
  bool is_keyframe = false;  ///< the scan is the newest keyframe
  bool lost = false;         ///< the scan fits nowhere, the pose is odometry's
  bool searched = false;     ///< odometry was no good start
  bool anchored = false;     ///< the drive's place in the map is known
  bool optimized = false;    ///< poses of older keyframes have changed
  double agreement = 0.0;    ///< of the scan with the local map, 0 to 1
};

/// What FeatureSlam is busy with, to tell where the time goes.
enum class SlamStage { kIdle, kTracking, kKeyframe, kLinks, kLoops, kOptimization };
const char* name_of(SlamStage stage);

/// All of the map that must outlive the process: keyframes with their scans, poses, constraints.
struct SlamState {
  std::vector<KeyframeRecord> keyframes;  ///< `odom_T_laser` is the tracker's pose
  PoseGraph graph;                        ///< of the lasers; ids are positions in `keyframes`
};

/// Simultaneous localization and mapping on features (thesis, Section 4.2.3) and on all points of
/// the scans between them.
///
/// Each scan is tracked by registration with the last keyframes; keyframes become nodes of a pose
/// graph, linked with the keyframes before, with those that the graph knows to be near, and, where
/// it does not, with the places that the loop detector recognises. Closures pass four gates:
/// score, verification on all points, consistency with odometry and with each other, robust loss.
///
/// Frames: `map` is the odometry's frame of the first drive (base_link at the first scan, without
/// odometry). A drive is what one odometry connects; a later one is anchored in the map by the
/// places that it sees again. Same scans, same results, bit by bit. Not thread-safe.
class FeatureSlam {
 public:
  /// Goes on with a state, if one is given: what is added then is another drive.
  /// Throws std::invalid_argument if parameters are wrong or the state's parts do not belong
  /// together.
  explicit FeatureSlam(const SlamParams& params = {}, const SlamState& state = {});
  ~FeatureSlam();
  FeatureSlam(FeatureSlam&&) noexcept;
  FeatureSlam& operator=(FeatureSlam&&) noexcept;

  SlamStep add(const SlamScan& scan);
  /// The odometry of the scans to come has nothing to do with that of those before.
  void begin_drive();
  /// A closure from elsewhere, which passes the same gates as those of the loop detector, its
  /// registration apart. Returns what became of it for now. Throws std::invalid_argument for
  /// keyframes that are not there.
  SlamClosure propose(KeyframeId target, KeyframeId source, const PoseEstimate& target_T_source);
  /// Optimises all of the graph, as after a drive.
  void finish();

  std::size_t keyframes() const;
  bool anchored() const;
  /// Of the laser, now. Throws std::out_of_range if there is no such keyframe.
  Pose2 map_T_laser(KeyframeId id) const;
  /// Whether its place in the map is known; else the pose is in a frame of its drive's own.
  bool is_mapped(KeyframeId id) const;
  const KeyframeRecord& record(KeyframeId id) const;
  /// All so far, with their verdicts as of now.
  const std::vector<SlamClosure>& closures() const;
  /// The poses of all that is mapped, and what is in force between them.
  PoseGraph graph() const;
  /// What is mapped. Ids are renumbered, drives that are not anchored left out.
  SlamState state() const;

  using StageListener = std::function<void(SlamStage)>;
  /// Is told whenever work of another kind begins.
  void on_stage(StageListener listener);

  const SlamParams& params() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace falko_slam
