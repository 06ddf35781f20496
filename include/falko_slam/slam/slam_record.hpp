// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/geometry/trajectory.hpp"
#include "falko_slam/map/grid_map.hpp"
#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

/// Remembers where the scans of a drive were taken, for the trajectory at its end.
class SlamRecord {
 public:
  void add(Time stamp, const SlamStep& step);

  /// Where each scan was thought to be when it came.
  Trajectory online() const;
  /// Where each scan was, by the graph as it is now.
  Trajectory final(const FeatureSlam& slam) const;

  std::size_t scans() const { return scans_.size(); }
  /// Scans that fitted nowhere, and scans for which odometry was no good start.
  std::size_t lost() const { return lost_; }
  std::size_t searched() const { return searched_; }

  std::size_t optimizations() const { return optimizations_; }  ///< of the graph, so far

 private:
  struct Scan {
    Time stamp;
    Pose2 map_T_base;
    std::optional<KeyframeId> keyframe;
    Pose2 keyframe_T_base;
  };
  std::vector<Scan> scans_;
  std::size_t lost_ = 0;
  std::size_t searched_ = 0;
  std::size_t optimizations_ = 0;
};

/// The occupancy grid of all keyframes whose place in the map is known.
GridMap map_of(const FeatureSlam& slam);

}  // namespace falko_slam
