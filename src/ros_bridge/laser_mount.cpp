// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/laser_mount.hpp"

#include <tf2/exceptions.h>

#include <utility>

#include "falko_slam/ros_bridge/pose_conversion.hpp"

namespace falko_slam {

LaserMount::LaserMount(std::string base_frame)
    : base_frame_(std::move(base_frame)), listener_(buffer_) {}

std::optional<bool> LaserMount::upside_down(const std::string& laser_frame) {
  const auto known = known_.find(laser_frame);
  if (known != known_.end()) return known->second;
  try {
    const auto mount = buffer_.lookupTransform(base_frame_, laser_frame, ros::Time(0));
    return known_[laser_frame] = turns_upside_down(mount.transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

}  // namespace falko_slam
