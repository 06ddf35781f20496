// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/geometry/trajectory.hpp"

namespace falko_slam {

/// The poses of a bag's topic of geometry_msgs/PoseStamped, with or without its leading slash, in
/// the order of the bag; empty topic: the only one. Poses in space are laid flat: x, y and yaw.
/// Throws std::runtime_error that names the file and what topics it has instead.
Trajectory read_pose_topic(const std::string& bag, const std::string& topic);

}  // namespace falko_slam
