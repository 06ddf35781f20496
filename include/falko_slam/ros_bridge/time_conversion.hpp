// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/duration.h>
#include <ros/time.h>

#include "falko_slam/common/time.hpp"

namespace falko_slam {

inline Time from_ros(const ros::Time& time) {
  return Time(std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec));
}

inline ros::Duration to_ros(Duration duration) {
  ros::Duration result;
  result.fromNSec(duration.count());
  return result;
}

/// Times outside of what ros::Time can hold (1970 to 2106) are moved to its nearest end.
ros::Time to_ros(Time time);

}  // namespace falko_slam
