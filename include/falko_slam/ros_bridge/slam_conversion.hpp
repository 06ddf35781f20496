// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/LoopConstraintArray.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <std_msgs/Header.h>

#include <vector>

#include "falko_slam/map/grid_map.hpp"
#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

/// With -1, 0 and 100 only, as planners expect it (see trinary_cell).
nav_msgs::OccupancyGrid to_message(const GridMap& map, const std_msgs::Header& header);

/// base_link at the keyframes that are in the map.
nav_msgs::Path path_of(const FeatureSlam& slam, const std_msgs::Header& header);

/// A closure with its verdict as of now, its covariance left out.
LoopConstraint to_message(const SlamClosure& closure, const FeatureSlam& slam);

/// Finds the closures that are new or whose verdict has changed.
class ClosureNews {
 public:
  /// Their numbers, since the last call.
  std::vector<std::size_t> changed(const std::vector<SlamClosure>& closures);
  /// All are new again.
  void reset() { told_.clear(); }

 private:
  std::vector<std::string> told_;  // verdicts
};

}  // namespace falko_slam
