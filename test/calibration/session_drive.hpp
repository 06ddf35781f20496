// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "falko_slam/calibration/calibration_session.hpp"
#include "falko_slam/simulation/simulated_vehicle.hpp"

namespace falko_slam {
namespace test {

/// Two short arcs in each phase.
inline CalibrationSessionParams short_session(const VehicleModel& model) {
  CalibrationSessionParams params;
  params.plan.arcs_per_phase = 2;
  params.plan.min_steering = 0.6;
  params.plan.max_steering = 1.0;
  params.plan.turn = 2.6;
  params.plan.rest = 1.5;
  params.driver.tricycle = model.nominal;
  params.driver.encoders = model.encoders;
  params.recorder.base_T_laser = model.nominal_base_T_laser;
  params.recorder.scan_duration = 0.0;
  return params;
}

/// A vehicle that a session leads, with an ideal scanner that sees nine reflectors at one instant,
/// eight times a second.
class SessionDrive {
 public:
  explicit SessionDrive(CalibrationSession& session) : session_(session) {}

  /// One control period of 25 ms.
  void step() {
    session_.add(vehicle_.reading());
    if (sees && periods_++ % 5 == 0) session_.add(observation());
    session_.catch_up();
    command = session_.next(vehicle_.time());
    vehicle_.drive(std::chrono::milliseconds(25), command);
  }
  /// Until the condition holds; false after so many steps.
  bool drive_until(const std::function<bool()>& condition, int steps = 40000) {
    for (int i = 0; i < steps && !condition(); ++i) step();
    return condition();
  }
  const SimulatedVehicle& vehicle() const { return vehicle_; }

  bool sees = true;
  WheelCommand command;
  static inline const VehicleModel kModel{};

 private:
  ReflectorObservation observation() const {
    const Pose2 world_T_laser = vehicle_.world_T_base() * kModel.base_T_laser;
    ReflectorObservation seen;
    seen.first_beam = vehicle_.time();
    for (int i = 0; i < 9; ++i) {
      const double angle = 0.7 * i + 0.02 * i * i;
      const Eigen::Vector2d reflector =
          (9.0 + i % 4) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      seen.reflectors.push_back({world_T_laser.inverse() * reflector, Duration::zero()});
    }
    return seen;
  }

  CalibrationSession& session_;
  SimulatedVehicle vehicle_{kModel, {}, Time{std::chrono::seconds(5)}, 1};
  int periods_ = 0;
};

}  // namespace test
}  // namespace falko_slam
