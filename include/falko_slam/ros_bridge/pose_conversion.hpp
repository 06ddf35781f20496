// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TransformStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <string>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

geometry_msgs::Pose to_message(const Pose2& pose);

/// One transform, parent_T_child.
tf2_msgs::TFMessage to_transform(const Pose2& parent_T_child, Time stamp, const std::string& parent,
                                 const std::string& child);

}  // namespace falko_slam
