// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <tf2_ros/transform_listener.h>

#include <optional>
#include <string>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// Where a vehicle is on a map on which nothing follows it for a while: the last pose there, and
/// since then what odometry says, with a deviation that grows with the way. After a long way, or
/// where odometry was interrupted, it is not known.
class PoseHandover {
 public:
  /// Odometry is tf `odom_frame` -> `base_frame`.
  PoseHandover(const ros::NodeHandle& node, std::string odom_frame, std::string base_frame);

  /// The pose on `map` from now on. One of which odometry knows nothing is forgotten.
  void keep(const std::string& map, const geometry_msgs::PoseWithCovarianceStamped& map_T_base);

  /// Adds up the way; to be called every second or so.
  void follow();

  /// Empty where it is not known. To be called after `follow`.
  std::optional<geometry_msgs::PoseWithCovarianceStamped> pose_on(const std::string& map) const;

 private:
  struct Kept {
    std::string map, map_frame;
    PoseEstimate map_T_base;
    Pose2 odom_T_base;    ///< there
    Pose2 odom_T_latest;  ///< of the base
    ros::Time latest;
    double way = 0.0;  ///< since then [m]
  };

  geometry_msgs::TransformStamped odom_T_base(ros::Time stamp) const;

  std::string odom_frame_, base_frame_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;  // with a thread of its own
  std::optional<Kept> kept_;
};

}  // namespace falko_slam
