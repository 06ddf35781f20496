// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/laser_pose.hpp"

#include <tf2/exceptions.h>

#include "falko_slam/ros_bridge/pose_conversion.hpp"

namespace falko_slam {

std::string tf_frame(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

LaserPoses::LaserPoses(const tf2::BufferCore& buffer, const std::string& odom_frame,
                       const std::string& base_frame)
    : buffer_(buffer), odom_frame_(tf_frame(odom_frame)), base_frame_(tf_frame(base_frame)) {}

LaserPlace LaserPoses::mount(const std::string& laser_frame) const {
  if (base_frame_.empty()) return {};
  const auto mount =
      buffer_.lookupTransform(base_frame_, tf_frame(laser_frame), ros::Time(0)).transform;
  return {in_plane(mount), turns_upside_down(mount)};
}

Pose2 LaserPoses::at(const std::string& laser_frame, const ros::Time& stamp) const {
  return in_plane(buffer_.lookupTransform(odom_frame_, tf_frame(laser_frame), stamp).transform);
}

std::optional<ros::Time> LaserPoses::newest(const std::string& laser_frame) const {
  const std::string frame = base_frame_.empty() ? tf_frame(laser_frame) : base_frame_;
  try {
    return buffer_.lookupTransform(odom_frame_, frame, ros::Time(0)).header.stamp;
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::vector<std::string> LaserPoses::frames() const {
  if (base_frame_.empty()) return {odom_frame_};
  return {odom_frame_, base_frame_};
}

}  // namespace falko_slam
