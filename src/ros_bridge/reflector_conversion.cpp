// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/reflector_conversion.hpp"

#include <cmath>

#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {

ReflectorObservation from_message(const ReflectorArray& message) {
  ReflectorObservation observation;
  observation.first_beam = from_ros(message.header.stamp);
  for (const Reflector& reflector : message.reflectors) {
    const Eigen::Vector2d point(reflector.position.x, reflector.position.y);
    if (!point.allFinite()) continue;
    observation.reflectors.push_back({point, Duration(reflector.time_offset.toNSec())});
  }
  return observation;
}

}  // namespace falko_slam
