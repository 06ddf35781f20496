// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/simulated_vehicle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/vehicle/wheel_command.hpp"
#include "support/simulated_worlds.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using std::chrono::milliseconds;
using test::kBegin;

// What its controller believes is true.
VehicleModel well_known() {
  VehicleModel model;
  model.nominal = model.tricycle;
  model.first_drive_ticks = 1000;
  return model;
}

// Steers at rest, then drives.
SimulatedVehicle arc_driven(const VehicleModel& model, double speed, double steering,
                            double seconds, std::uint64_t seed = 1) {
  SimulatedVehicle vehicle(model, {}, kBegin, seed);
  for (int i = 0; i < 150; ++i) vehicle.drive(test::kControlPeriod, WheelCommand{0.0, steering});
  for (double t = 0.0; t < seconds - 1e-9; t += 0.02) {
    vehicle.drive(test::kControlPeriod, WheelCommand{speed, steering});
  }
  return vehicle;
}

TEST(SimulatedVehicle, TicksAndPoseOfAnArcAreThoseOfTheModel) {
  const VehicleModel model = well_known();
  for (const double speed : {0.5, -0.5}) {
    const SimulatedVehicle vehicle = arc_driven(model, speed, 0.6, 11.0);

    // A second of acceleration at 0.5 m/s^2, ten seconds at 0.5 m/s.
    const double ticks = std::copysign(5.25 / model.nominal.driving_scale, speed);
    const auto counted = static_cast<std::int32_t>(vehicle.reading().drive_ticks - 1000U);
    EXPECT_NEAR(counted, ticks, 1.01);
    const Pose2 expected = drive_arc(model.tricycle, ticks, 0.6);
    EXPECT_LT((expected.inverse() * vehicle.world_T_base()).log().norm(), 1e-6);
    EXPECT_NEAR(steering_of(model.encoders, vehicle.reading().steer_ticks), 0.6, 1e-4);
  }
}

TEST(SimulatedVehicle, DrivingBackUndoesNothingOfTheAsymmetry) {
  VehicleModel model = well_known();
  model.tricycle.steer_offset_forward = 0.03;
  model.tricycle.steer_offset_backward = -0.02;
  const SimulatedVehicle forward = arc_driven(model, 0.5, 0.0, 10.0);
  const SimulatedVehicle backward = arc_driven(model, -0.5, 0.0, 10.0);

  EXPECT_GT(forward.world_T_base().theta(), 0.05);   // to the left, forward
  EXPECT_GT(backward.world_T_base().theta(), 0.03);  // to the right, backward: turns left, too
}

TEST(SimulatedVehicle, CountersRunOverTheirEnds) {
  VehicleModel model = well_known();
  model.first_drive_ticks = 4294967290U;
  model.encoders.steer_ticks_per_turn = 8192;

  const SimulatedVehicle forward = arc_driven(model, 0.5, -0.3, 2.0);
  EXPECT_LT(forward.reading().drive_ticks, 10000U);
  EXPECT_GT(forward.reading().steer_ticks, 7000U);  // right of straight ahead: below a full turn
  model.first_drive_ticks = 5;
  const SimulatedVehicle backward = arc_driven(model, -0.5, 0.3, 2.0);
  EXPECT_GT(backward.reading().drive_ticks, 4294900000U);
  EXPECT_LT(backward.reading().steer_ticks, 1000U);
}

TEST(SimulatedVehicle, ActuatorsHaveLimits) {
  const VehicleModel model = well_known();
  SimulatedVehicle vehicle(model, {}, kBegin, 1);

  vehicle.drive(milliseconds(500), WheelCommand{9.0, 9.0});
  EXPECT_NEAR(vehicle.wheel_speed(), 0.5 * model.actuators.acceleration, 1e-9);
  EXPECT_NEAR(vehicle.steering(), 0.5 * model.actuators.steer_rate, 1e-9);
  vehicle.drive(std::chrono::seconds(20), WheelCommand{9.0, 9.0});
  EXPECT_EQ(vehicle.wheel_speed(), model.actuators.max_wheel_speed);
  EXPECT_EQ(vehicle.steering(), model.actuators.max_steering);
}

TEST(SimulatedVehicle, ControllerWithAWrongScaleDrivesAnotherSpeed) {
  VehicleModel model = well_known();
  model.nominal.driving_scale = 1.05 * model.tricycle.driving_scale;
  const SimulatedVehicle vehicle = arc_driven(model, 0.5, 0.0, 11.0);

  EXPECT_NEAR(vehicle.world_T_base().translation().norm(), 5.25 / 1.05, 1e-3);
}

// Spread of the driven way of many runs, as a share of it.
double spread(const WheelErrors& errors, double seconds) {
  VehicleModel model = well_known();
  model.tricycle.steer_offset_forward = 0.0;
  model.errors = errors;
  constexpr int kRuns = 400;
  double squares = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const SimulatedVehicle vehicle =
        arc_driven(model, 0.5, 0.0, seconds, static_cast<std::uint64_t>(run));
    const double expected = 0.5 * (seconds - 0.5);
    const double error = vehicle.world_T_base().x() / expected - 1.0;
    squares += error * error;
  }
  return std::sqrt(squares / kRuns);
}

TEST(SimulatedVehicle, SlipsAsMuchAsItIsTold) {
  WheelErrors of_run, of_phase, of_way;
  of_run.slip_per_run = 0.01;
  of_phase.slip_per_phase = 0.01;
  of_way.slip_per_root_metre = 0.01;

  EXPECT_NEAR(spread(of_run, 4.5), 0.01, 0.0015);
  EXPECT_NEAR(spread(of_phase, 4.5), 0.01, 0.0015);
  EXPECT_NEAR(spread(of_way, 4.5), 0.01 / std::sqrt(2.0), 0.0012);
}

TEST(SimulatedVehicle, SlipOfAPhaseIsTheSameInEachOfItsRuns) {
  VehicleModel model = well_known();
  model.errors.slip_per_phase = 0.05;
  SimulatedVehicle vehicle(model, {}, kBegin, 3);
  double ways[2];
  for (double& way : ways) {
    const Pose2 begin = vehicle.world_T_base();
    vehicle.drive(std::chrono::seconds(3), WheelCommand{0.4, 0.0});
    vehicle.drive(std::chrono::seconds(2), WheelCommand{0.0, 0.0});
    way = (begin.inverse() * vehicle.world_T_base()).translation().norm();
  }
  EXPECT_NEAR(ways[0], ways[1], 1e-9);
}

}  // namespace
}  // namespace falko_slam
