// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_node_params.hpp"

#include <stdexcept>

#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/calibration_node_fields.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"

namespace falko_slam {
namespace {

EncoderParams encoders_of(const BelievedVehicle& vehicle) {
  constexpr int kMost = 2147483647;
  require_in_range("vehicle/steer_ticks_per_turn", vehicle.steer_ticks_per_turn, 1, kMost);
  require_in_range("vehicle/steer_zero", vehicle.steer_zero, 0, kMost);
  EncoderParams encoders;
  encoders.steer_ticks_per_turn = static_cast<std::uint32_t>(vehicle.steer_ticks_per_turn);
  encoders.steer_zero = static_cast<std::uint32_t>(vehicle.steer_zero);
  encoders.steer_gain = vehicle.steer_gear;
  return encoders;
}

void take(const BelievedVehicle& vehicle, CalibrationNodeParams& params) {
  VehicleCalibration calibration = vehicle.calibration;
  calibration.base_T_laser = Pose2(vehicle.laser_x, vehicle.laser_y, vehicle.laser_theta);
  if (!params.start.empty()) calibration = read_calibration(params.start).calibration;
  believe(calibration, params.session);
  params.session.driver.encoders = encoders_of(vehicle);
}

}  // namespace

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

const EnumNames<EncoderSource>& encoder_source_names() {
  static const EnumNames<EncoderSource> names = {{"encoders", EncoderSource::kTicks},
                                                 {"joint_states", EncoderSource::kJoints}};
  return names;
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
  require_in_range("drive_ticks_per_turn", params.drive_ticks_per_turn, 1, 2147483647);
  for (const std::string* frame : {&params.odom_frame, &params.base_frame}) {
    if (frame->empty()) throw std::invalid_argument("odom_frame and base_frame must have names");
  }
  validate(params.session);
}

CalibrationNodeParams read_calibration_node_params(const XmlRpc::XmlRpcValue& tree,
                                                   const std::string& name,
                                                   std::vector<std::string>& unknown) {
  CalibrationNodeParams params;
  BelievedVehicle vehicle;
  ParameterReader reader(tree, name);
  visit_calibration_node_fields(params, vehicle, reader);
  unknown = reader.unknown({"num_worker_threads", "diagnostic_period"});
  params.odom_frame = tf_frame(params.odom_frame);
  params.base_frame = tf_frame(params.base_frame);
  params.folder = params.folder.empty() ? default_file_folder() : with_home(params.folder);
  params.start = path_in(params.folder, params.start);
  try {
    take(vehicle, params);
    validate(params);
  } catch (const std::exception& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
  return params;
}

}  // namespace falko_slam
