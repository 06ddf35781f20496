// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/place_recognition/keyframe_memory.hpp"
#include "falko_slam/slam/feature_slam.hpp"
#include "falko_slam/slam/motion_deskew.hpp"
#include "slam_graph.hpp"

namespace falko_slam {

/// The steps of FeatureSlam, from a scan to the graph.
struct FeatureSlam::Impl {
  Impl(const SlamParams& params, const SlamState& state);

  SlamParams params;
  MotionDeskew motion;
  ScanTracker tracker;
  KeyframeMemory memory;
  SlamGraph graph;
  std::vector<SlamClosure> closures;
  std::vector<std::size_t> proposed;  // closures by the number of their proposal
  bool new_drive = true;              // the next scan begins one
  StageListener listener;

  SlamStep add(const SlamScan& scan);
  void begin_drive();
  void propose(SlamClosure closure, const PoseEstimate& target_T_source);
  /// Optimises all, and takes out what the map contradicts in the end.
  void finish();
  SlamState state() const;

  void enter(SlamStage stage) const {
    if (listener) listener(stage);
  }
  KeyframeId add_keyframe(const SlamScan& scan, const TrackedScan& tracked);
  void link_with_neighbors(KeyframeId id);
  bool link_with_nearby(KeyframeId id);
  void close_loops(KeyframeId id);

  const ScanView& view(KeyframeId id) const { return memory.keyframe(id).view; }
};

}  // namespace falko_slam
