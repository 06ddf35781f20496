// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/vehicle_params.hpp"

#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"

namespace falko_slam {
namespace {

constexpr int kMost = 2147483647;

}  // namespace

const EnumNames<EncoderSource>& encoder_source_names() {
  static const EnumNames<EncoderSource> names = {{"encoders", EncoderSource::kTicks},
                                                 {"joint_states", EncoderSource::kJoints}};
  return names;
}

VehicleCalibration calibration_of(const VehicleParams& vehicle, const std::string& folder) {
  if (!vehicle.calibration_file.empty()) {
    return read_calibration(path_in(folder, with_home(vehicle.calibration_file))).calibration;
  }
  VehicleCalibration calibration = vehicle.calibration;
  calibration.base_T_laser = Pose2(vehicle.laser_x, vehicle.laser_y, vehicle.laser_theta);
  return calibration;
}

EncoderParams encoders_of(const VehicleParams& vehicle) {
  require_in_range("steer_ticks_per_turn", vehicle.steer_ticks_per_turn, 1, kMost);
  require_in_range("steer_zero", vehicle.steer_zero, 0, kMost);
  EncoderParams encoders;
  encoders.steer_ticks_per_turn = static_cast<std::uint32_t>(vehicle.steer_ticks_per_turn);
  encoders.steer_zero = static_cast<std::uint32_t>(vehicle.steer_zero);
  encoders.steer_gain = vehicle.steer_gear;
  validate(encoders);
  return encoders;
}

JointParams joints_of(const VehicleParams& vehicle) {
  require_in_range("drive_ticks_per_turn", vehicle.drive_ticks_per_turn, 1, kMost);
  JointParams joints;
  joints.encoders = encoders_of(vehicle);
  joints.drive_ticks_per_turn = static_cast<std::uint32_t>(vehicle.drive_ticks_per_turn);
  return joints;
}

}  // namespace falko_slam
