// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "encoder_track.hpp"

#include <algorithm>

namespace falko_slam {
namespace {

constexpr Duration kRemembered = std::chrono::seconds(10);

}  // namespace

EncoderTrack::EncoderTrack(const TricycleParams& tricycle, const EncoderParams& encoders,
                           const Pose2& base_T_laser)
    : encoders_(encoders), base_T_laser_(base_T_laser), odometry_(tricycle, encoders) {}

bool EncoderTrack::add(const EncoderReading& reading) {
  const auto last = odometry_.reading();
  const OdometryStep step = odometry_.add(reading);
  if (step.verdict == OdometryVerdict::kNotLater) return false;
  EncoderInstant now{reading.stamp, odometry_.odom_T_base() * base_T_laser_, 0,
                     steering_of(encoders_, reading.steer_ticks), false};
  if (last && !instants_.empty()) {
    const EncoderInstant& before = instants_.back();
    now.ticks = before.ticks + step.ticks;
    now.steering =
        before.steering + steering_between(encoders_, last->steer_ticks, reading.steer_ticks);
    now.moving = step.ticks != 0;
  }
  instants_.push_back(now);
  while (instants_.size() > 2 && now.stamp - instants_[1].stamp > kRemembered) {
    instants_.pop_front();
  }
  return true;
}

std::optional<EncoderInstant> EncoderTrack::at(Time time) const {
  const auto after =
      std::lower_bound(instants_.begin(), instants_.end(), time,
                       [](const EncoderInstant& instant, Time t) { return instant.stamp < t; });
  if (after == instants_.end() || (after == instants_.begin() && after->stamp > time)) {
    return std::nullopt;
  }
  if (after->stamp == time) return *after;
  const EncoderInstant& before = *std::prev(after);
  const double share = to_seconds(time - before.stamp) / to_seconds(after->stamp - before.stamp);
  EncoderInstant between = before;
  between.stamp = time;
  between.odom_T_laser =
      before.odom_T_laser *
      Pose2::exp(share * (before.odom_T_laser.inverse() * after->odom_T_laser).log());
  between.moving = after->moving;
  return between;
}

}  // namespace falko_slam
