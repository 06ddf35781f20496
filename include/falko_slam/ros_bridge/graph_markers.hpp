// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

/// The graph for rviz, in the map's frame: keyframes as spheres ("keyframes"), and as lines the way
/// from each to the next ("odometry"), other registrations of scans ("registrations"), closures
/// ("closures", green) and the last refused or pending ones that have got as far as a pose
/// ("refused_closures", red).
visualization_msgs::MarkerArray graph_markers(const FeatureSlam& slam,
                                              const std_msgs::Header& header);

/// Takes away all that was drawn.
visualization_msgs::MarkerArray no_markers(const std_msgs::Header& header);

/// Of the refused closures the last ones stay.
constexpr std::size_t kMostRefusedClosures = 300;

}  // namespace falko_slam
