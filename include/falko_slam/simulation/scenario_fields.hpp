// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "falko_slam/simulation/laser_model.hpp"
#include "falko_slam/simulation/vehicle_model.hpp"

namespace falko_slam {

// The names of what a scenario's laser and vehicle are made of: their one home, and what
// doc/scenarios.md explains. A visitor has begin, end and field as in feature_extractor_fields.hpp;
// some fields here are std::size_t or std::uint32_t. The structs may be const.

template <class Model, class Visitor>
void visit_laser_model_fields(Model& laser, Visitor& visitor) {
  visitor.field("beams", laser.beams);
  visitor.field("angle_min", laser.angle_min);
  visitor.field("angle_increment", laser.angle_increment);
  visitor.field("scan_period", laser.scan_period);
  visitor.field("time_increment", laser.time_increment);
  visitor.field("nearest", laser.nearest);
  visitor.field("farthest", laser.farthest);
  visitor.field("range_of_dark", laser.range_of_dark);
  visitor.field("beam_diameter", laser.beam_diameter);
  visitor.field("beam_divergence", laser.beam_divergence);
  visitor.field("echo_separation", laser.echo_separation);
  visitor.field("range_noise", laser.range_noise);
  visitor.field("range_step", laser.range_step);
  visitor.field("bearing_noise", laser.bearing_noise);
  visitor.field("drop_out", laser.drop_out);
  visitor.field("intensities", laser.intensities);
  visitor.field("white_intensity", laser.white_intensity);
  visitor.field("intensity_exponent", laser.intensity_exponent);
  visitor.field("stated_range_min", laser.stated_range_min);
  visitor.field("stated_range_max", laser.stated_range_max);
}

template <class Params, class Visitor>
void visit_tricycle_fields(const char* group, Params& params, Visitor& visitor) {
  visitor.begin(group);
  visitor.field("wheelbase", params.wheelbase);
  visitor.field("driving_scale", params.driving_scale);
  visitor.field("steer_offset_forward", params.steer_offset_forward);
  visitor.field("steer_offset_backward", params.steer_offset_backward);
  visitor.end();
}

template <class Pose, class Visitor>
void visit_pose_fields(const char* group, Pose& pose, Visitor& visitor) {
  double x = pose.x();
  double y = pose.y();
  double theta = pose.theta();
  visitor.begin(group);
  visitor.field("x", x);
  visitor.field("y", y);
  visitor.field("theta", theta);
  visitor.end();
  if constexpr (!std::is_const_v<Pose>) pose = Pose(x, y, theta);
}

template <class Params, class Visitor>
void visit_encoder_fields(Params& params, Visitor& visitor) {
  visitor.begin("encoders");
  visitor.field("steer_ticks_per_turn", params.steer_ticks_per_turn);
  visitor.field("steer_zero", params.steer_zero);
  visitor.field("steer_gain", params.steer_gain);
  visitor.end();
}

template <class Model, class Visitor>
void visit_actuator_fields(Model& actuators, Visitor& visitor) {
  visitor.begin("actuators");
  visitor.field("max_wheel_speed", actuators.max_wheel_speed);
  visitor.field("acceleration", actuators.acceleration);
  visitor.field("max_steering", actuators.max_steering);
  visitor.field("steer_rate", actuators.steer_rate);
  visitor.field("command_timeout", actuators.command_timeout);
  visitor.end();
}

template <class Errors, class Visitor>
void visit_wheel_error_fields(Errors& errors, Visitor& visitor) {
  visitor.begin("errors");
  visitor.field("slip_per_run", errors.slip_per_run);
  visitor.field("slip_per_phase", errors.slip_per_phase);
  visitor.field("slip_per_root_metre", errors.slip_per_root_metre);
  visitor.field("steering_per_run", errors.steering_per_run);
  visitor.field("steering_per_phase", errors.steering_per_phase);
  visitor.end();
}

template <class Model, class Visitor>
void visit_vehicle_model_fields(Model& vehicle, Visitor& visitor) {
  visit_tricycle_fields("tricycle", vehicle.tricycle, visitor);
  visit_pose_fields("base_T_laser", vehicle.base_T_laser, visitor);
  visit_tricycle_fields("nominal", vehicle.nominal, visitor);
  visit_pose_fields("nominal_base_T_laser", vehicle.nominal_base_T_laser, visitor);
  visit_encoder_fields(vehicle.encoders, visitor);
  visitor.field("first_drive_ticks", vehicle.first_drive_ticks);
  visitor.field("encoder_rate", vehicle.encoder_rate);
  visit_actuator_fields(vehicle.actuators, visitor);
  visit_wheel_error_fields(vehicle.errors, visitor);
}

}  // namespace falko_slam
