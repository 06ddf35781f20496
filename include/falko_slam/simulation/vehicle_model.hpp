// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "falko_slam/vehicle/encoder_reading.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// What drives and steers the wheel.
struct ActuatorModel {
  double max_wheel_speed = 1.5;              ///< [m/s]
  double acceleration = 0.5;                 ///< of the wheel, and its braking [m/s^2]
  double max_steering = 1.3962634015954636;  ///< to either side, 80 degrees [rad]
  double steer_rate = 0.7853981633974483;    ///< 45 degrees a second [rad/s]
  double command_timeout = 0.5;              ///< without a command for so long it halts [s]
};

/// How the wheel's motion differs from what the encoders say; standard deviations. A run lasts from
/// halt to halt; runs of the same direction and steering side share an error of their phase.
struct WheelErrors {
  double slip_per_run = 0.0;    ///< share of the way
  double slip_per_phase = 0.0;  ///< share of the way
  double slip_per_root_metre =
      0.0;                          ///< share of the way of a metre; of longer ways it averages out
  double steering_per_run = 0.0;    ///< [rad]
  double steering_per_phase = 0.0;  ///< [rad]
};

/// A tricycle AGV: what it is, and what its controller takes it for. Default: a CB16 of
/// \cite kallasi2017, Tables 5.1 and 5.2.
struct VehicleModel {
  TricycleParams tricycle{1.358, 2.4975e-4, -0.012566370614359173, -0.013613568165555770};
  Pose2 base_T_laser{0.389, 0.0025, 0.00715584993317675};
  TricycleParams nominal{1.358, 2.5e-4, 0.0, 0.0};
  Pose2 nominal_base_T_laser{0.390, 0.0, 0.0};
  EncoderParams encoders;
  std::uint32_t first_drive_ticks = 4294900000U;  ///< soon over its end
  double encoder_rate = 50.0;                     ///< readings a second; a control period each
  ActuatorModel actuators;
  WheelErrors errors;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const VehicleModel& vehicle);

}  // namespace falko_slam
