// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/laser_pose.hpp"

#include <tf2/exceptions.h>

#include <utility>

#include "falko_slam/ros_bridge/pose_conversion.hpp"

namespace falko_slam {

LaserPoses::LaserPoses(const tf2::BufferCore& buffer, std::string odom_frame,
                       std::string base_frame)
    : buffer_(buffer), odom_frame_(std::move(odom_frame)), base_frame_(std::move(base_frame)) {}

LaserPlace LaserPoses::mount(const std::string& laser_frame) const {
  if (base_frame_.empty()) return {};
  const auto mount = buffer_.lookupTransform(base_frame_, laser_frame, ros::Time(0)).transform;
  return {in_plane(mount), turns_upside_down(mount)};
}

Pose2 LaserPoses::at(const std::string& laser_frame, const ros::Time& stamp) const {
  return in_plane(buffer_.lookupTransform(odom_frame_, laser_frame, stamp).transform);
}

std::optional<ros::Time> LaserPoses::newest(const std::string& laser_frame) const {
  const std::string& frame = base_frame_.empty() ? laser_frame : base_frame_;
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
