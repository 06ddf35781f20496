// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/odometry_track.hpp"

#include <algorithm>

#include "falko_slam/localization/pose_history.hpp"

namespace falko_slam {
namespace {

constexpr Duration kMaxExtrapolation = std::chrono::milliseconds(200);

}  // namespace

void OdometryTrack::add(Time stamp, const PoseEstimate& motion) {
  auto next = steps_.end();
  while (next != steps_.begin() && std::prev(next)->stamp >= stamp) --next;
  if (next != steps_.end() && (next == steps_.begin() || next->stamp == stamp)) return;
  next = steps_.insert(next, Step{stamp, motion, {}});
  if (next == steps_.begin()) ++next;
  for (; next != steps_.end(); ++next) {
    next->odom_T_base = std::prev(next)->odom_T_base * next->motion.pose;
  }
  while (steps_.size() > 2 && steps_[1].stamp < end() - span_) steps_.pop_front();
}

Pose2 OdometryTrack::at(Time time) const {
  if (steps_.empty()) return {};
  const auto later = [](const Step& step, Time t) { return step.stamp < t; };
  auto next = std::lower_bound(steps_.begin(), steps_.end(), time, later);
  if (next == steps_.begin()) return next->odom_T_base;
  if (next == steps_.end()) {
    --next;
    if (next == steps_.begin()) return next->odom_T_base;
    time = std::min(time, next->stamp + kMaxExtrapolation);
  }
  const Step& before = *std::prev(next);
  const double share = to_seconds(time - before.stamp) / to_seconds(next->stamp - before.stamp);
  return before.odom_T_base * Pose2::exp(share * next->motion.pose.log());
}

std::vector<std::pair<Time, PoseEstimate>> OdometryTrack::since(Time from) const {
  std::vector<std::pair<Time, PoseEstimate>> motions;
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (step.stamp <= from) continue;
    const Time before = std::max(from, steps_[i - 1].stamp);
    const double share =
        to_seconds(step.stamp - before) / to_seconds(step.stamp - steps_[i - 1].stamp);
    motions.emplace_back(step.stamp, part_of_motion(step.motion, share));
  }
  return motions;
}

PoseEstimate OdometryTrack::between(Time from, Time to) const {
  PoseEstimate way;
  for (const auto& [stamp, motion] : since(from)) {
    if (stamp > to) break;
    way = compose(way, motion);
  }
  way.pose = at(from).inverse() * at(to);
  return way;
}

}  // namespace falko_slam
