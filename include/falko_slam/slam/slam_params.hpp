// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/map/occupancy_grid.hpp"
#include "falko_slam/place_recognition/loop_detector.hpp"
#include "falko_slam/pose_graph/consistency.hpp"
#include "falko_slam/pose_graph/optimizer.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/slam/nearby_keyframes.hpp"
#include "falko_slam/slam/scan_link.hpp"
#include "falko_slam/slam/scan_tracker.hpp"

namespace falko_slam {

struct SlamGraphParams {
  /// Keyframes before a new one that it is linked with, besides the local map. [0, 100]
  int neighbors = 2;
  /// Standard deviation of the tracker's way from one keyframe to the next, added to its own.
  /// [1e-4, 10] [m], [rad]
  double step_distance = 0.02;
  double step_turn = 0.02;
  /// The graph is optimised at once if a closure shows that the map is off by more than this, else
  /// when so many keyframes have come since the last time. [0, 100] [m], [0, pi] [rad], [1, 1e6]
  double urgent_distance = 0.10;
  double urgent_turn = 0.03;
  int optimize_every = 50;
  /// A drive whose place in the map is not known is put there when two closures of different
  /// keyframes agree to this. [0.01, 100] [m], [0.01, pi] [rad]
  double anchor_distance = 0.5;
  double anchor_turn = 0.1;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SlamGraphParams& params);

/// All that a SLAM is set up with: the same for every recording and vehicle.
struct SlamParams {
  ScanNormalizerParams scan;
  /// Scans that take time are freed of the motion under way, see MotionDeskew.
  bool deskew = true;
  ScanTrackerParams tracker;
  ScanLinkParams link;
  NearbyKeyframesParams nearby;
  LoopDetectorParams loops;  ///< its `odometry` is not used: the tracker does more
  SlamGraphParams graph;
  ConsistencyParams consistency;
  OptimizerParams optimizer;
  OccupancyGridParams map;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SlamParams& params);

}  // namespace falko_slam
