// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>

#include "falko_slam/sensor/deskew.hpp"

namespace falko_slam {

/// Frees the scans of a drive from the motion of the laser while it takes them: the motion from the
/// scan before to this one is taken to have gone on, that of the odometry or, where there is none,
/// that of the last two steps that were found. Of two, because an error of one step would bend the
/// next scan, which would be found off to the other side: the errors would go on for ever, and
/// grow.
///
/// Scans before any motion is known stay as they are, and so do those of a laser that would be
/// faster than 10 m/s or 6 rad/s, or after more than 1 s without any. Not thread-safe.
class MotionDeskew {
 public:
  /// For each scan in turn: as it would be at its stamp.
  LaserScan apply(const LaserScan& scan, Time stamp, const std::optional<Pose2>& odom_T_laser);
  /// Where the scan of the last `apply` was found.
  void found(const Pose2& track_T_laser);
  /// What comes next has nothing to do with what was before.
  void reset();

 private:
  struct Taken {
    Time stamp;
    std::optional<Pose2> odom_T_laser;
    std::optional<Pose2> track_T_laser;
  };
  LaserMotion motion_until(const Taken& now) const;

  std::deque<Taken> last_;  // the newest at the end
};

}  // namespace falko_slam
