// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/localization/landmark_map.hpp"

namespace falko_slam {

/// Where a vehicle was last, for the next start.
struct SavedPose {
  Time stamp{};
  PoseEstimate map_T_base;
  std::string map;  ///< identity_of() the map that it is on
};

/// The same for maps with the same landmarks at the same places, whatever their file, order and
/// covariances: "23 landmarks, 5ec2f0a1".
std::string identity_of(const LandmarkMap& map);

/// As YAML, whole or not at all. Throws std::invalid_argument for a pose that is not finite or has
/// no covariance, std::runtime_error that names the file if it cannot be written; then the old one
/// is still there.
void write_saved_pose(const std::string& path, const SavedPose& pose);

/// Throws std::runtime_error that names file, line and key.
SavedPose read_saved_pose(const std::string& path);

/// Why it is not to be started from now, in words; empty: it is. It must be of this map, not from
/// the future, as after a clock was set back, and not older than `max_age`.
std::string objection_to(const SavedPose& pose, const std::string& map, Time now, Duration max_age);

}  // namespace falko_slam
