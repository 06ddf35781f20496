// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_node_params.hpp"

#include <exception>
#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {
namespace {

void validate_frames(const LocalizerNodeParams& params) {
  for (const std::string* frame : {&params.map_frame, &params.odom_frame, &params.base_frame}) {
    if (frame->empty()) throw std::invalid_argument("frames must have names");
  }
  if (params.map_frame == params.odom_frame) {
    throw std::invalid_argument("map_frame and odom_frame are both " + params.map_frame);
  }
}

}  // namespace

const EnumNames<MotionSource>& motion_source_names() {
  static const EnumNames<MotionSource> names = {{"encoders", MotionSource::kEncoders},
                                                {"odom", MotionSource::kOdometry}};
  return names;
}

const EnumNames<SightSource>& sight_source_names() {
  static const EnumNames<SightSource> names = {{"scan", SightSource::kScan},
                                               {"reflectors", SightSource::kReflectors}};
  return names;
}

void validate(const LocalizerNodeParams& params) {
  validate_frames(params);
  if (params.map_file.empty()) {
    throw std::invalid_argument("map_file is empty: there must be a map of landmarks");
  }
  require_in_range("transform_period", params.transform_period, 0.001, 10.0);
  require_in_range("transform_tolerance", params.transform_tolerance, 0.0, 10.0);
  require_in_range("input_timeout", params.input_timeout, 0.01, 1e6);
  require_in_range("warn_position", params.warn_position, 0.0, 1000.0);
  require_in_range("warn_heading", params.warn_heading, 0.0, 4.0);
  require_in_range("pose_save_period", params.pose_save_period, 0.1, 1e6);
  require_in_range("pose_max_age", params.pose_max_age, 0.0, 1e9);
  const InitialPose& initial = params.initial_pose;
  require_in_range("initial_pose/x", initial.x, -1e5, 1e5);
  require_in_range("initial_pose/y", initial.y, -1e5, 1e5);
  require_in_range("initial_pose/theta", initial.theta, -100.0, 100.0);
  require_in_range("initial_pose/position_deviation", initial.position_deviation, 0.0, 1000.0);
  require_in_range("initial_pose/heading_deviation", initial.heading_deviation, 0.0, 4.0);
  require_in_range("odometry_noise/distance", params.odometry_noise.distance, 0.0, 1.0);
  require_in_range("odometry_noise/turn", params.odometry_noise.turn, 0.0, 1.0);
  require_in_range("odometry_noise/turn_by_turn", params.odometry_noise.turn_by_turn, 0.0, 1.0);
  validate(params.noise);
  validate(params.scan);
  validate(params.calibration.tricycle);
  validate(params.encoders);
  validate(params.localizer);
}

LocalizerNodeParams read_localizer_node_params(const XmlRpc::XmlRpcValue& tree,
                                               const std::string& name,
                                               std::vector<std::string>& unknown) {
  ParameterReader reader(tree, name);
  LocalizerNodeParams params;
  visit_localizer_node_fields(params, reader);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});
  for (std::string* frame : {&params.map_frame, &params.odom_frame, &params.base_frame}) {
    *frame = tf_frame(*frame);
  }
  const std::string folder = default_file_folder();
  params.map_file = path_in(folder, params.map_file);
  params.pose_file = path_in(folder, params.pose_file);
  try {
    params.calibration = calibration_of(params.vehicle, folder);
    params.encoders = joints_of(params.vehicle).encoders;
    params.encoders.steer_gain *= params.calibration.steer_gain;
    params.localizer.base_T_laser = params.calibration.base_T_laser;
    validate(params);
  } catch (const std::exception& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
  return params;
}

}  // namespace falko_slam
