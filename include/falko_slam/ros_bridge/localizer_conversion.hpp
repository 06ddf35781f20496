// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/LandmarkArray.h>
#include <falko_slam/LocalizerStatus.h>
#include <falko_slam/ReflectorArray.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>

#include <string>
#include <vector>

#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/localization/landmark.hpp"
#include "falko_slam/localization/landmark_filter.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/localizer_report.hpp"
#include "falko_slam/ros_bridge/localizer_node_params.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {

LocalizerStatus to_message(const LocalizerReport& report, const std::string& map_frame);

/// The landmarks of the map that the last scan was matched with, each once, and all of the state.
LandmarkArray landmarks_in_use(const LocalizerReport& report, const LandmarkMap& map,
                               const std::vector<ActiveLandmark>& in_state,
                               const std::string& map_frame);

geometry_msgs::PoseWithCovarianceStamped pose_message(const PoseEstimate& map_T_base, Time stamp,
                                                      const std::string& map_frame);

/// A pose as somebody says it: in the frame of the map, or an empty one, laid flat. Where its
/// covariance of x, y and yaw is all zero that of `initial` is taken. Throws std::invalid_argument
/// for another frame, what is not finite, no rotation or no covariance.
PoseEstimate from_message(const geometry_msgs::PoseWithCovarianceStamped& message,
                          const std::string& map_frame, const InitialPose& initial);

/// What a device found, moved to where the laser saw it at the header's stamp: it corrects nothing
/// for the vehicle's motion. Ids are those of a map that the device was taught and not looked at.
std::vector<LandmarkObservation> reflector_observations(const ReflectorArray& message,
                                                        const BaseVelocity& velocity,
                                                        const Pose2& base_T_laser,
                                                        const ReflectorDetectorParams& noise);

/// Standard deviations of a pose along and across the vehicle [m] and of its heading [rad].
Eigen::Vector3d deviations_of(const PoseEstimate& map_T_base);

}  // namespace falko_slam
