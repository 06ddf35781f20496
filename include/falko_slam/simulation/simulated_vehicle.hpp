// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

#include "falko_slam/simulation/motion_track.hpp"
#include "falko_slam/simulation/vehicle_model.hpp"
#include "falko_slam/vehicle/wheel_command.hpp"

namespace falko_slam {

/// What recorded encoders went through.
struct EncoderMotion {
  double ticks = 0.0;     ///< of the driven wheel
  double steering = 0.0;  ///< at the end [rad]
};

/// A tricycle that drives: actuators with limits, wheels with errors, encoders that count.
///
/// Commands and recorded readings move the encoders; the errors of WheelErrors lie between them and
/// the true motion, which is made of exact arcs of a millisecond.
class SimulatedVehicle {
 public:
  /// Throws std::invalid_argument for a model that is none.
  SimulatedVehicle(const VehicleModel& model, const Pose2& world_T_base, Time start,
                   std::uint64_t seed);

  /// Obeys as well as its actuators can.
  void drive(Duration duration, const WheelCommand& command);
  /// Moves as the encoders of another vehicle did, limits or not.
  void drive(Duration duration, const EncoderMotion& motion);

  Time time() const { return track_.end(); }
  const Pose2& world_T_base() const { return track_.last(); }
  const MotionTrack& track() const { return track_; }
  void forget_before(Time time) { track_.forget_before(time); }
  double wheel_speed() const { return wheel_speed_; }  ///< by its encoders and nominal scale [m/s]
  double steering() const { return steering_; }        ///< before it is rounded to ticks [rad]
  EncoderReading reading() const;

 private:
  void move(Duration duration, double ticks, double steering);
  void begin_run();
  double white_slip(double way);

  VehicleModel model_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  MotionTrack track_;
  double ticks_ = 0.0;  // since the start
  double wheel_speed_ = 0.0;
  double steering_ = 0.0;
  double slip_of_phase_[2][2] = {};      // by direction and side
  double steering_of_phase_[2][2] = {};  // [rad]
  double slip_of_run_ = 0.0;
  double steering_of_run_ = 0.0;
  bool stands_ = true;
};

}  // namespace falko_slam
