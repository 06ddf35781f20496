// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/motion_track.hpp"

#include <algorithm>

namespace falko_slam {

MotionTrack::MotionTrack(Time begin, const Pose2& world_T_body)
    : end_(begin), last_(world_T_body) {}

void MotionTrack::add(Duration duration, const Eigen::Vector3d& step) {
  if (duration <= Duration::zero()) return;
  pieces_.push_back({end_, duration, last_, step});
  end_ += duration;
  last_ = last_ * Pose2::exp(step);
}

Pose2 MotionTrack::at(Time time) const {
  if (pieces_.empty() || time >= end_) return last_;
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                      [](Time t, const Piece& piece) { return t < piece.begin; });
  if (after == pieces_.begin()) return pieces_.front().world_T_begin;
  const Piece& piece = *std::prev(after);
  if (piece.step.isZero(0.0)) return piece.world_T_begin;
  const double share = to_seconds(time - piece.begin) / to_seconds(piece.duration);
  return piece.world_T_begin * Pose2::exp(share * piece.step);
}

void MotionTrack::forget_before(Time time) {
  while (!pieces_.empty() && pieces_.front().begin + pieces_.front().duration < time) {
    pieces_.pop_front();
  }
}

}  // namespace falko_slam
