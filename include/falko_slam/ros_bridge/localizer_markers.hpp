// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/localizer_report.hpp"

namespace falko_slam {

/// A localizer for rviz, in the frame of the map: its landmarks ("reflectors" as yellow columns,
/// "features" blue), what the last scan saw of them ("used" green lines from the laser,
/// "strangers" red ones to what fits nothing), and the pose with an ellipse of three standard
/// deviations ("pose", "deviation"). Without a pose there is the map only.
visualization_msgs::MarkerArray localizer_markers(const LocalizerReport& report,
                                                  const LandmarkMap& map, const Pose2& base_T_laser,
                                                  const std::string& map_frame);

}  // namespace falko_slam
