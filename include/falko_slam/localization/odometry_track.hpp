// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// What the odometry said of the last seconds, to ask where base_link was in between.
class OdometryTrack {
 public:
  /// Remembers so much before the last motion.
  explicit OdometryTrack(Duration span) : span_(span) {}

  /// The motion from the motion before, by stamps, to this one. Of a stamp that is there already,
  /// or from before the track: left out.
  void add(Time stamp, const PoseEstimate& motion);
  void clear() { steps_.clear(); }

  bool empty() const { return steps_.empty(); }
  Time begin() const { return steps_.front().stamp; }
  Time end() const { return steps_.back().stamp; }

  /// Where base_link was, in a frame that is the track's own: between motions at constant velocity.
  /// After the last one it goes on as it moved before for 0.2 s; before the first one it stands.
  Pose2 at(Time time) const;

  /// From one time to a later one, with the covariance of the pieces.
  PoseEstimate between(Time from, Time to) const;

  /// The motions that follow a time, the first one cut there.
  std::vector<std::pair<Time, PoseEstimate>> since(Time from) const;

 private:
  struct Step {
    Time stamp{};
    PoseEstimate motion;  // that led here
    Pose2 odom_T_base;
  };

  std::deque<Step> steps_;  // by stamp; the first one is where the track begins
  Duration span_;
};

}  // namespace falko_slam
