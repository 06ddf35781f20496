// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "falko_slam/localization/landmark_filter.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/localizer_report.hpp"

namespace falko_slam {

/// A localizer for rviz, in the frame of the map: its landmarks ("reflectors" as yellow columns,
/// "features" blue), what the last scan saw of them ("used" green lines from the laser,
/// "strangers" red ones to what fits nothing), the landmarks that only the state holds
/// ("state_points", and "state_faces" as far as they were seen; turquoise), and the pose with an
/// ellipse of three standard deviations ("pose", "deviation"). Without a pose there is the map
/// only.
visualization_msgs::MarkerArray localizer_markers(const LocalizerReport& report,
                                                  const LandmarkMap& map,
                                                  const std::vector<ActiveLandmark>& in_state,
                                                  const Pose2& base_T_laser,
                                                  const std::string& map_frame);

}  // namespace falko_slam
