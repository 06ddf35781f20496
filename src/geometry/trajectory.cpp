// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/trajectory.hpp"

#include <algorithm>
#include <utility>

namespace falko_slam {
namespace {

using Microseconds = std::chrono::duration<std::int64_t, std::micro>;

Time rounded(Time stamp) {
  return Time(std::chrono::round<Microseconds>(stamp.time_since_epoch()));
}

bool earlier(const StampedPose& a, const StampedPose& b) { return a.stamp < b.stamp; }
bool simultaneous(const StampedPose& a, const StampedPose& b) { return a.stamp == b.stamp; }

}  // namespace

TrajectoryIndex::TrajectoryIndex(Trajectory trajectory) : poses_(std::move(trajectory)) {
  for (StampedPose& pose : poses_) pose.stamp = rounded(pose.stamp);
  std::stable_sort(poses_.begin(), poses_.end(), earlier);
  poses_.erase(std::unique(poses_.begin(), poses_.end(), simultaneous), poses_.end());
}

std::optional<Pose2> TrajectoryIndex::at(Time stamp) const {
  const StampedPose wanted{rounded(stamp), {}};
  const auto found = std::lower_bound(poses_.begin(), poses_.end(), wanted, earlier);
  if (found == poses_.end() || found->stamp != wanted.stamp) return std::nullopt;
  return found->map_T_base;
}

std::optional<Pose2> TrajectoryIndex::interpolate(Time stamp, Duration max_gap) const {
  if (auto pose = at(stamp)) return pose;
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), StampedPose{stamp, {}}, earlier);
  if (after == poses_.begin() || after == poses_.end()) return std::nullopt;
  const StampedPose& before = *std::prev(after);
  const Duration gap = after->stamp - before.stamp;
  if (gap > max_gap) return std::nullopt;
  const double share = to_seconds(stamp - before.stamp) / to_seconds(gap);
  const Pose2 way = before.map_T_base.inverse() * after->map_T_base;
  return before.map_T_base * Pose2::exp(share * way.log());
}

}  // namespace falko_slam
