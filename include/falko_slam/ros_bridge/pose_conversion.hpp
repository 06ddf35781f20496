// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Pose2D.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <std_msgs/Header.h>
#include <tf2_msgs/TFMessage.h>

#include <string>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

geometry_msgs::Pose to_message(const Pose2& pose);

/// [m], [m], [rad]; the angle may have whole turns.
geometry_msgs::Pose2D pose2d(double x, double y, double theta);

std_msgs::Header header_of(Time stamp, const std::string& frame);

geometry_msgs::PoseStamped stamped_pose(const Pose2& frame_T_pose, Time stamp,
                                        const std::string& frame);

/// Without velocity and covariances.
nav_msgs::Odometry odometry_message(const Pose2& odom_T_base, Time stamp, const std::string& odom,
                                    const std::string& base);

/// The covariances of z, roll and pitch are 0.
geometry_msgs::PoseWithCovariance to_message(const PoseEstimate& estimate);

/// What a transform does in the plane: where it puts the origin, and where the x axis points then.
Pose2 in_plane(const geometry_msgs::Transform& transform);
Pose2 in_plane(const geometry_msgs::Pose& pose);

/// The z axis points down after it.
bool turns_upside_down(const geometry_msgs::Transform& transform);

/// One transform, parent_T_child.
tf2_msgs::TFMessage to_transform(const Pose2& parent_T_child, Time stamp, const std::string& parent,
                                 const std::string& child);

}  // namespace falko_slam
