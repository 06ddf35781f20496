// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/motion_deskew.hpp"

#include <cmath>
#include <cstddef>

namespace falko_slam {
namespace {

constexpr double kLongestGap = 1.0;   // [s]
constexpr double kFastest = 10.0;     // [m/s]
constexpr double kFastestTurn = 6.0;  // [rad/s]

constexpr std::size_t kScans = 3;

bool plausible(const LaserMotion& motion) {
  const double seconds = to_seconds(motion.duration);
  return seconds > 0.0 && seconds <= kLongestGap &&
         motion.begin_T_end.translation().norm() <= kFastest * seconds &&
         std::abs(motion.begin_T_end.theta()) <= kFastestTurn * seconds;
}

}  // namespace

void MotionDeskew::reset() { last_.clear(); }

void MotionDeskew::found(const Pose2& track_T_laser) {
  if (!last_.empty()) last_.back().track_T_laser = track_T_laser;
}

LaserMotion MotionDeskew::motion_until(const Taken& now) const {
  if (last_.empty() || to_seconds(now.stamp - last_.back().stamp) > kLongestGap) return {};
  const Taken& before = last_.back();
  if (before.odom_T_laser && now.odom_T_laser) {
    return {before.odom_T_laser->inverse() * *now.odom_T_laser, now.stamp - before.stamp};
  }
  const Taken& first = last_.front();
  if (last_.size() < kScans || !first.track_T_laser || !before.track_T_laser) return {};
  return {first.track_T_laser->inverse() * *before.track_T_laser, before.stamp - first.stamp};
}

LaserScan MotionDeskew::apply(const LaserScan& scan, Time stamp,
                              const std::optional<Pose2>& odom_T_laser) {
  const Taken now{stamp, odom_T_laser, std::nullopt};
  const LaserMotion motion = motion_until(now);
  last_.push_back(now);
  if (last_.size() > kScans) last_.pop_front();
  return plausible(motion) ? deskew(scan, motion, stamp) : scan;
}

}  // namespace falko_slam
