// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2_ros/transform_listener.h>

#include <map>
#include <optional>
#include <string>

namespace falko_slam {

/// Tells from tf whether lasers hang upside down: their z axis points down in the base frame.
/// The answer is looked up once for each laser; mounts do not move.
class LaserMount {
 public:
  explicit LaserMount(std::string base_frame);

  /// Empty as long as tf does not connect the frames.
  std::optional<bool> upside_down(const std::string& laser_frame);

 private:
  std::string base_frame_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  std::map<std::string, bool> known_;
};

}  // namespace falko_slam
