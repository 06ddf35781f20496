// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "encoder_input.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/ros_bridge/localizer_node_params.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {

/// A motion of base_link since the one before.
struct VehicleMotion {
  Time stamp{};
  PoseEstimate motion;
  std::optional<Pose2> odom_T_base;  ///< of an odometry that is not ours
  BaseVelocity velocity;
};

/// The motions of a vehicle, from its encoders or from an odometry. Calls come from the node's
/// queue. After a clock was set back it begins anew with the first input of the new time.
class MotionInput {
 public:
  struct Listener {
    std::function<void(const VehicleMotion&)> moved;
    std::function<void(double seconds)> time_has_jumped;  ///< back by so much
  };
  MotionInput(const ros::NodeHandle& node, const LocalizerNodeParams& params, Listener listener);

  HeardTopic topic() const;

 private:
  void on_reading(const EncoderReading& reading);
  void on_odometry(const nav_msgs::OdometryConstPtr& message);
  bool is_late(Time stamp, Time last);
  PoseEstimate motion_of(const Pose2& motion) const;

  LocalizerNodeParams params_;
  Listener listener_;
  TricycleOdometry odometry_;
  std::optional<Time> last_stamp_;
  Pose2 last_odom_T_base_;
  std::unique_ptr<EncoderInput> encoders_;
  ros::Subscriber odometry_messages_;
};

}  // namespace falko_slam
