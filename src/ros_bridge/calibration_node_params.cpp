// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_node_params.hpp"

#include <stdexcept>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/calibration_node_fields.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {
const EnumNames<EgomotionSource>& egomotion_source_names() {
  static const EnumNames<EgomotionSource> names = {
      {name_of(EgomotionSource::kReflectors), EgomotionSource::kReflectors},
      {name_of(EgomotionSource::kScans), EgomotionSource::kScans}};
  return names;
}

const EnumNames<TricycleModel>& tricycle_model_names() {
  static const EnumNames<TricycleModel> names = {{"asymmetric", TricycleModel::kAsymmetric},
                                                 {"standard", TricycleModel::kStandard}};
  return names;
}

TricycleModel tricycle_model_of(const std::string& name) {
  if (const auto model = value_of(name, tricycle_model_names())) return *model;
  throw std::invalid_argument("model = " + name + ": must be " +
                              list_names(tricycle_model_names()));
}

VehicleCalibration believed_calibration(const CalibrationSessionParams& params) {
  return {params.driver.tricycle, params.calibrator.steer_gain, params.recorder.base_T_laser};
}

void believe(const VehicleCalibration& calibration, CalibrationSessionParams& params) {
  params.driver.tricycle = calibration.tricycle;
  params.recorder.tricycle = calibration.tricycle;
  params.recorder.base_T_laser = calibration.base_T_laser;
  params.calibrator.wheelbase = calibration.tricycle.wheelbase;
  params.calibrator.steer_gain = calibration.steer_gain;
}

void validate(const CalibrationNodeParams& params) {
  require_in_range("control_period", params.control_period, 0.001, 1.0);
  require_in_range("feedback_period", params.feedback_period, 0.01, 60.0);
  for (const std::string* frame : {&params.odom_frame, &params.base_frame}) {
    if (frame->empty()) throw std::invalid_argument("odom_frame and base_frame must have names");
  }
  validate(params.session);
  validate(params.scan);
}

CalibrationNodeParams read_calibration_node_params(const XmlRpc::XmlRpcValue& tree,
                                                   const std::string& name,
                                                   std::vector<std::string>& unknown) {
  CalibrationNodeParams params;
  ParameterReader reader(tree, name);
  visit_calibration_node_fields(params, reader);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});
  params.odom_frame = tf_frame(params.odom_frame);
  params.base_frame = tf_frame(params.base_frame);
  params.folder = params.folder.empty() ? default_file_folder() : with_home(params.folder);
  try {
    believe(calibration_of(params.vehicle, params.folder), params.session);
    params.session.driver.encoders = joints_of(params.vehicle).encoders;
    validate(params);
  } catch (const std::exception& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
  return params;
}

}  // namespace falko_slam
