// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/odometry_node_params.hpp"

#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {

void validate(const OdometryNodeParams& params) {
  validate(params.calibration.tricycle);
  validate(params.encoders);
  validate(params.odometry);
  validate(params.noise);
  require_in_range("encoder_timeout", params.encoder_timeout, 0.01, 1e6);
  for (const std::string* frame : {&params.odom_frame, &params.base_frame, &params.laser_frame}) {
    if (frame->empty()) throw std::invalid_argument("frames must have names");
  }
}

OdometryNodeParams read_odometry_node_params(const XmlRpc::XmlRpcValue& tree,
                                             const std::string& name,
                                             std::vector<std::string>& unknown) {
  ParameterReader reader(tree, name);
  OdometryNodeParams params;
  visit_odometry_node_fields(params, reader);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});
  for (std::string* frame : {&params.odom_frame, &params.base_frame, &params.laser_frame}) {
    *frame = tf_frame(*frame);
  }
  try {
    params.calibration = calibration_of(params.vehicle, default_file_folder());
    params.encoders = joints_of(params.vehicle).encoders;
    params.encoders.steer_gain *= params.calibration.steer_gain;
    validate(params);
  } catch (const std::exception& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
  return params;
}

}  // namespace falko_slam
