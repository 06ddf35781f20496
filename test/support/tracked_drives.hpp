// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/slam/scan_tracker.hpp"
#include "support/slam_drives.hpp"

namespace falko_slam {
namespace test {

/// All scans of a drive, keyframes kept.
inline std::vector<TrackedScan> follow(const SlamDrive& drive,
                                       ScanTracker tracker = ScanTracker()) {
  std::vector<TrackedScan> tracked;
  for (const SlamInput& input : drive) {
    std::optional<Pose2> odom;
    if (input.scan.odom_T_base) odom = *input.scan.odom_T_base * input.scan.base_T_laser;
    tracked.push_back(tracker.track(input.scan.scan, input.scan.stamp, odom));
    if (tracked.back().keyframe) tracker.keep(input.scan.scan);
  }
  return tracked;
}

inline Pose2 true_laser(const SlamDrive& drive, std::size_t scan) {
  return drive[scan].world_T_base * drive[scan].scan.base_T_laser;
}

/// The worst error of the way from one scan to the one that comes `scans` later [m].
inline double greatest_drift(const std::vector<TrackedScan>& tracked, const SlamDrive& drive,
                             std::size_t scans) {
  double worst = 0.0;
  for (std::size_t i = 0; i + scans < tracked.size(); ++i) {
    const Pose2 way = tracked[i].track_T_laser.inverse() * tracked[i + scans].track_T_laser;
    const Pose2 truth = true_laser(drive, i).inverse() * true_laser(drive, i + scans);
    worst = std::max(worst, distance(way, truth));
  }
  return worst;
}

inline std::size_t count(const std::vector<TrackedScan>& tracked, bool TrackedScan::*what) {
  return static_cast<std::size_t>(std::count_if(
      tracked.begin(), tracked.end(), [what](const TrackedScan& scan) { return scan.*what; }));
}

}  // namespace test
}  // namespace falko_slam
