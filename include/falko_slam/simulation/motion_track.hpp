// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// Where a vehicle was at every instant: arcs that follow each other without a gap.
class MotionTrack {
 public:
  MotionTrack(Time begin, const Pose2& world_T_body);

  /// On from where it ends: `step` is the arc's tangent, driven evenly.
  void add(Duration duration, const Eigen::Vector3d& step);

  Time begin() const { return pieces_.empty() ? end_ : pieces_.front().begin; }
  Time end() const { return end_; }
  const Pose2& last() const { return last_; }
  /// The nearest end for times before or after. O(log pieces).
  Pose2 at(Time time) const;

  /// What is before this time may be forgotten.
  void forget_before(Time time);

 private:
  struct Piece {
    Time begin;
    Duration duration;
    Pose2 world_T_begin;
    Eigen::Vector3d step;
  };
  std::deque<Piece> pieces_;
  Time end_;
  Pose2 last_;
};

}  // namespace falko_slam
