// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/layout_follower_params.hpp"

#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {

void validate(const LayoutFollowerNodeParams& params) {
  require_in_range("pose_timeout", params.pose_timeout, 0.05, 60.0);
  validate(params.follower);
  validate(params.encoders);
}

LayoutFollowerNodeParams read_layout_follower_params(const XmlRpc::XmlRpcValue& tree,
                                                     const std::string& name,
                                                     std::vector<std::string>& unknown) {
  ParameterReader reader(tree, name);
  LayoutFollowerNodeParams params;
  visit_layout_follower_fields(params, reader);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});
  try {
    const VehicleCalibration calibration = calibration_of(params.vehicle, default_file_folder());
    params.follower.tricycle = calibration.tricycle;
    params.follower.steer_gain = calibration.steer_gain;
    params.encoders = joints_of(params.vehicle).encoders;
    validate(params);
    params.layout = read_layout(params.layout_file);
  } catch (const std::exception& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
  return params;
}

}  // namespace falko_slam
