// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/pose_conversion.hpp"

#include <cmath>

#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {

geometry_msgs::Pose to_message(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x();
  message.position.y = pose.y();
  message.orientation.z = std::sin(0.5 * pose.theta());
  message.orientation.w = std::cos(0.5 * pose.theta());
  return message;
}

tf2_msgs::TFMessage to_transform(const Pose2& parent_T_child, Time stamp, const std::string& parent,
                                 const std::string& child) {
  const geometry_msgs::Pose pose = to_message(parent_T_child);
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = to_ros(stamp);
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.position.x;
  transform.transform.translation.y = pose.position.y;
  transform.transform.rotation = pose.orientation;
  tf2_msgs::TFMessage message;
  message.transforms = {transform};
  return message;
}

}  // namespace falko_slam
