// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// Without the leading slash that old drivers write and tf2 refuses.
std::string tf_frame(const std::string& name);

/// How a laser is mounted, in the plane.
struct LaserPlace {
  Pose2 base_T_laser;
  /// Its z axis points down in the base frame; empty if there is no base frame to tell.
  std::optional<bool> upside_down;
};

/// Where tf says that lasers are. Poses are those of the laser turned upright: x along beam angle
/// 0, z up. With an empty base frame the laser is its own base.
class LaserPoses {
 public:
  /// Borrows the buffer.
  LaserPoses(const tf2::BufferCore& buffer, const std::string& odom_frame,
             const std::string& base_frame);

  /// The newest one. Throws tf2::TransformException.
  LaserPlace mount(const std::string& laser_frame) const;
  /// odom_T_laser. Throws tf2::TransformException.
  Pose2 at(const std::string& laser_frame, const ros::Time& stamp) const;

  /// Of what tf knows of the vehicle in the odometry's frame. Empty if it knows nothing.
  std::optional<ros::Time> newest(const std::string& laser_frame) const;

  /// To which scans must be connected.
  std::vector<std::string> frames() const;

 private:
  const tf2::BufferCore& buffer_;
  std::string odom_frame_;
  std::string base_frame_;
};

}  // namespace falko_slam
