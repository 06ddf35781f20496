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

geometry_msgs::Pose2D pose2d(double x, double y, double theta) {
  geometry_msgs::Pose2D pose;
  pose.x = x;
  pose.y = y;
  pose.theta = theta;
  return pose;
}

std_msgs::Header header_of(Time stamp, const std::string& frame) {
  std_msgs::Header header;
  header.stamp = to_ros(stamp);
  header.frame_id = frame;
  return header;
}

geometry_msgs::PoseStamped stamped_pose(const Pose2& frame_T_pose, Time stamp,
                                        const std::string& frame) {
  geometry_msgs::PoseStamped message;
  message.header = header_of(stamp, frame);
  message.pose = to_message(frame_T_pose);
  return message;
}

nav_msgs::Odometry odometry_message(const Pose2& odom_T_base, Time stamp, const std::string& odom,
                                    const std::string& base) {
  nav_msgs::Odometry message;
  message.header = header_of(stamp, odom);
  message.child_frame_id = base;
  message.pose.pose = to_message(odom_T_base);
  return message;
}

geometry_msgs::PoseWithCovariance to_message(const PoseEstimate& estimate) {
  constexpr Eigen::Index kSixth[] = {0, 1, 5};  // x, y and the rotation about z of six
  geometry_msgs::PoseWithCovariance message;
  message.pose = to_message(estimate.pose);
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      const auto cell = static_cast<std::size_t>(6 * kSixth[i] + kSixth[j]);
      message.covariance[cell] = estimate.covariance(i, j);
    }
  }
  return message;
}

Pose2 in_plane(const geometry_msgs::Transform& transform) {
  geometry_msgs::Pose pose;
  pose.position.x = transform.translation.x;
  pose.position.y = transform.translation.y;
  pose.orientation = transform.rotation;
  return in_plane(pose);
}

Pose2 in_plane(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  const double heading =
      std::atan2(2.0 * (q.x * q.y + q.w * q.z), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  return {pose.position.x, pose.position.y, heading};
}

bool turns_upside_down(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  return 1.0 - 2.0 * (q.x * q.x + q.y * q.y) < 0.0;
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
