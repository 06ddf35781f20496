// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// A world for rviz: what stands ("world"), reflectors ("reflectors") and what moves or comes and
/// goes
/// ("things"), where it is at `seconds` since the world began.
visualization_msgs::MarkerArray world_markers(const World& world, double seconds,
                                              const std_msgs::Header& header);

}  // namespace falko_slam
