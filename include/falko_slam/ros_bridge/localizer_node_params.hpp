// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <string>
#include <vector>

#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/features/feature_extractor_fields.hpp"
#include "falko_slam/localization/localizer_fields.hpp"
#include "falko_slam/localization/localizer_params.hpp"
#include "falko_slam/ros_bridge/vehicle_params.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"

namespace falko_slam {

/// Where motions come from.
enum class MotionSource {
  kEncoders,  ///< the vehicle's, in the messages that VehicleParams names
  kOdometry,  ///< nav_msgs/Odometry on `odom`
};
const EnumNames<MotionSource>& motion_source_names();

/// Where reflectors come from.
enum class SightSource {
  kScan,        ///< found in the intensities of `scan`, and corners with them
  kReflectors,  ///< falko_slam/ReflectorArray on `reflectors`, as the device finds them
};
const EnumNames<SightSource>& sight_source_names();

/// Noise of the motions of an odometry that is not ours, new on every piece of the way.
struct MotionNoise {
  double distance = 0.01;      ///< of the way, in each direction [m / sqrt(m)]
  double turn = 0.005;         ///< of the heading, by the way [rad / sqrt(m)]
  double turn_by_turn = 0.01;  ///< of the heading, by the turn [rad / sqrt(rad)]
};

/// Where the vehicle stands at the start, if somebody knows.
struct InitialPose {
  bool known = false;
  double x = 0.0, y = 0.0, theta = 0.0;  ///< map_T_base [m], [rad]
  /// Standard deviations of this pose, and of any that is set without a covariance [m], [rad].
  double position_deviation = 0.3, heading_deviation = 0.1;
};

/// Parameters of the Localizer node; what they mean stands in config/localizer.yaml.
struct LocalizerNodeParams {
  std::string map_frame = "map", odom_frame = "odom", base_frame = "base_link";
  std::string map_file;  ///< of landmarks, .yaml or .imk: there is no localizer without
  MotionSource motion_source = MotionSource::kEncoders;
  SightSource sight_source = SightSource::kScan;
  bool publish_tf = true;
  double transform_period = 0.03;     ///< [s], [0.001, 10]
  double transform_tolerance = 0.05;  ///< [s], [0, 10]
  double input_timeout = 1.0;         ///< [s], [0.01, 1e6]
  double warn_position = 0.05;        ///< [m], [0, 1000]
  double warn_heading = 0.02;         ///< [rad], [0, 4]
  std::string pose_file;              ///< empty: none
  double pose_save_period = 5.0;      ///< [s], [0.1, 1e6]
  double pose_max_age = 86400.0;      ///< [s], [0, 1e9]
  InitialPose initial_pose;
  OdometryNoise noise;
  MotionNoise odometry_noise;
  ScanNormalizerParams scan;
  VehicleParams vehicle;
  VehicleCalibration calibration;  ///< what the vehicle's parameters and its file say
  EncoderParams encoders;          ///< the same, with the calibrated steer gain
  LocalizerParams localizer;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LocalizerNodeParams& params);

template <class Params, class Visitor>
void visit_localizer_node_inputs(Params& params, Visitor& visitor) {
  visitor.field("map_file", params.map_file);
  visitor.field("map_frame", params.map_frame);
  visitor.field("odom_frame", params.odom_frame);
  visitor.field("base_frame", params.base_frame);
  visitor.choice("motion_source", params.motion_source, motion_source_names());
  visitor.choice("sight_source", params.sight_source, sight_source_names());
  visitor.field("publish_tf", params.publish_tf);
  visitor.field("transform_period", params.transform_period);
  visitor.field("transform_tolerance", params.transform_tolerance);
  visitor.field("input_timeout", params.input_timeout);
  visitor.field("warn_position", params.warn_position);
  visitor.field("warn_heading", params.warn_heading);
  visitor.field("pose_file", params.pose_file);
  visitor.field("pose_save_period", params.pose_save_period);
  visitor.field("pose_max_age", params.pose_max_age);
}

template <class Params, class Visitor>
void visit_initial_pose_fields(Params& pose, Visitor& visitor) {
  visitor.field("known", pose.known);
  visitor.field("x", pose.x);
  visitor.field("y", pose.y);
  visitor.field("theta", pose.theta);
  visitor.field("position_deviation", pose.position_deviation);
  visitor.field("heading_deviation", pose.heading_deviation);
}

template <class Params, class Visitor>
void visit_localizer_node_fields(Params& params, Visitor& visitor) {
  const auto group = [&](const char* name, auto&& visit) {
    visitor.begin(name);
    visit();
    visitor.end();
  };
  visit_localizer_node_inputs(params, visitor);
  group("initial_pose", [&] { visit_initial_pose_fields(params.initial_pose, visitor); });
  group("noise", [&] {
    visitor.field("slip", params.noise.slip);
    visitor.field("steer", params.noise.steer);
  });
  group("odometry_noise", [&] {
    visitor.field("distance", params.odometry_noise.distance);
    visitor.field("turn", params.odometry_noise.turn);
    visitor.field("turn_by_turn", params.odometry_noise.turn_by_turn);
  });
  group("scan", [&] { visit_scan_fields(params.scan, visitor); });
  group("vehicle", [&] { visit_vehicle_fields(params.vehicle, visitor); });
  visit_localizer_fields(params.localizer, visitor);
  group("falko", [&] { visit_falko_fields(params.localizer.features.falko, visitor); });
}

/// `name` stands before the names in messages; `unknown` gets the names that no field has. Files
/// come with their whole paths. Throws std::invalid_argument with the parameter's full name, or
/// that of the calibration's file.
LocalizerNodeParams read_localizer_node_params(const XmlRpc::XmlRpcValue& tree,
                                               const std::string& name,
                                               std::vector<std::string>& unknown);

}  // namespace falko_slam
