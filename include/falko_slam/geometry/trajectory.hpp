// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

struct StampedPose {
  Time stamp{};
  Pose2 map_T_base;
};

/// The poses of a vehicle in the order in which they were recorded: stamps may repeat themselves
/// and run backwards, as those of real logs do.
using Trajectory = std::vector<StampedPose>;

/// Finds poses of a trajectory by their stamp.
///
/// Stamps are compared in whole microseconds, rounded: logs have no more digits. Where several
/// poses have the same stamp, the first one of the trajectory counts. O(log n) each.
class TrajectoryIndex {
 public:
  explicit TrajectoryIndex(Trajectory trajectory);

  std::optional<Pose2> at(Time stamp) const;

  /// Between the poses before and after the stamp, along the arc of constant velocities that
  /// connects them. Empty outside of the trajectory and in gaps longer than `max_gap`.
  std::optional<Pose2> interpolate(Time stamp, Duration max_gap) const;

 private:
  Trajectory poses_;  // by stamp, each stamp once
};

}  // namespace falko_slam
