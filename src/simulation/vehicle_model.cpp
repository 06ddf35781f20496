// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/vehicle_model.hpp"

#include <stdexcept>
#include <string>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

void validate(const Pose2& base_T_laser) {
  require_in_range("x", base_T_laser.x(), -20.0, 20.0);
  require_in_range("y", base_T_laser.y(), -20.0, 20.0);
  require_in_range("theta", base_T_laser.theta(), -kPi, kPi);
}

void validate(const ActuatorModel& actuators) {
  require_in_range("max_wheel_speed", actuators.max_wheel_speed, 0.01, 20.0);
  require_in_range("acceleration", actuators.acceleration, 0.01, 100.0);
  require_in_range("max_steering", actuators.max_steering, 0.01, kPi);
  require_in_range("steer_rate", actuators.steer_rate, 0.01, 100.0);
  require_in_range("command_timeout", actuators.command_timeout, 0.01, 60.0);
}

void validate(const WheelErrors& errors) {
  require_in_range("slip_per_run", errors.slip_per_run, 0.0, 0.5);
  require_in_range("slip_per_phase", errors.slip_per_phase, 0.0, 0.5);
  require_in_range("slip_per_root_metre", errors.slip_per_root_metre, 0.0, 0.5);
  require_in_range("steering_per_run", errors.steering_per_run, 0.0, 0.5);
  require_in_range("steering_per_phase", errors.steering_per_phase, 0.0, 0.5);
}

// Names the group: the two tricycles have the same fields, for one.
template <class Group>
void validate_group(const char* name, const Group& group) {
  try {
    validate(group);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(name) + "." + error.what());
  }
}

}  // namespace

void validate(const VehicleModel& vehicle) {
  validate_group("tricycle", vehicle.tricycle);
  validate_group("base_T_laser", vehicle.base_T_laser);
  validate_group("nominal", vehicle.nominal);
  validate_group("nominal_base_T_laser", vehicle.nominal_base_T_laser);
  validate_group("encoders", vehicle.encoders);
  require_in_range("encoder_rate", vehicle.encoder_rate, 1.0, 1000.0);
  validate_group("actuators", vehicle.actuators);
  validate_group("errors", vehicle.errors);
}

}  // namespace falko_slam
