// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/calibration/vehicle_calibration.hpp"
#include "falko_slam/common/enum_names.hpp"
#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/vehicle/encoder_reading.hpp"

namespace falko_slam {

/// Which messages the encoders come in.
enum class EncoderSource {
  kTicks,   ///< falko_slam/TricycleEncoders on `encoders`
  kJoints,  ///< sensor_msgs/JointState on `joint_states`
};
const EnumNames<EncoderSource>& encoder_source_names();

/// A tricycle and its laser as they stand in the group `vehicle` of a node's parameters.
struct VehicleParams {
  std::string calibration_file;  ///< of `falko calibrate` or the Calibration node; empty: none
  VehicleCalibration calibration;
  double laser_x = 0.0, laser_y = 0.0, laser_theta = 0.0;  ///< base_T_laser [m], [rad]
  EncoderSource encoder_source = EncoderSource::kTicks;
  int drive_ticks_per_turn = 5000;  ///< for EncoderSource::kJoints
  int steer_ticks_per_turn = 65536, steer_zero = 0;
  double steer_gear = 1.0;  ///< steer_gain of EncoderParams
};

template <class Params, class Visitor>
void visit_vehicle_fields(Params& vehicle, Visitor& visitor) {
  visitor.field("calibration_file", vehicle.calibration_file);
  visitor.field("wheelbase", vehicle.calibration.tricycle.wheelbase);
  visitor.field("driving_scale", vehicle.calibration.tricycle.driving_scale);
  visitor.field("steer_offset_forward", vehicle.calibration.tricycle.steer_offset_forward);
  visitor.field("steer_offset_backward", vehicle.calibration.tricycle.steer_offset_backward);
  visitor.field("steer_gain", vehicle.calibration.steer_gain);
  visitor.field("laser_x", vehicle.laser_x);
  visitor.field("laser_y", vehicle.laser_y);
  visitor.field("laser_theta", vehicle.laser_theta);
  visitor.choice("encoder_source", vehicle.encoder_source, encoder_source_names());
  visitor.field("drive_ticks_per_turn", vehicle.drive_ticks_per_turn);
  visitor.field("steer_ticks_per_turn", vehicle.steer_ticks_per_turn);
  visitor.field("steer_zero", vehicle.steer_zero);
  visitor.field("steer_gear", vehicle.steer_gear);
}

/// What the vehicle is: the calibration's file, where one is named (relative: below the folder),
/// counts before the other parameters. Throws std::runtime_error that names the file.
VehicleCalibration calibration_of(const VehicleParams& vehicle, const std::string& folder);

/// How its encoders count. Throws std::invalid_argument with the field and its value.
EncoderParams encoders_of(const VehicleParams& vehicle);
JointParams joints_of(const VehicleParams& vehicle);

}  // namespace falko_slam
