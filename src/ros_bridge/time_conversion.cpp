// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/time_conversion.hpp"

#include <algorithm>

namespace falko_slam {

ros::Time to_ros(Time time) {
  const auto last = static_cast<std::int64_t>(ros::TIME_MAX.toNSec());
  const std::int64_t nanoseconds = time.time_since_epoch().count();
  ros::Time result;
  result.fromNSec(static_cast<std::uint64_t>(std::clamp<std::int64_t>(nanoseconds, 0, last)));
  return result;
}

}  // namespace falko_slam
