// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "falko_slam/calibration/calibration_plan.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/simulated_vehicle.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

constexpr Time kBegin{std::chrono::seconds(5)};

CalibrationPlan short_plan() {
  CalibrationPlan plan;
  plan.arcs_per_phase = 2;
  plan.turn = 1.0;
  plan.rest = 0.6;
  plan.max_distance = 20.0;
  return plan;
}

/// A vehicle that a calibration drives.
class Driven : public ::testing::Test {
 protected:
  Driven() : vehicle_(model_, {}, kBegin, 1) { make(short_plan()); }

  void make(const CalibrationPlan& plan) {
    CalibrationDriverParams params;
    params.tricycle = model_.nominal;
    params.encoders = model_.encoders;
    driver_ = std::make_unique<CalibrationDriver>(plan, params);
  }
  void step() {
    if (encoders_) driver_->add(vehicle_.reading());
    if (scans_) driver_->add_scan(vehicle_.time(), 5);
    command_ = driver_->next(vehicle_.time());
    vehicle_.drive(test::kControlPeriod, command_);
  }
  void drive(double seconds) {
    for (double t = 0.0; t < seconds; t += 0.02) step();
  }
  // Until it drives an arc at speed.
  void drive_on_arc() {
    for (int i = 0; i < 2000 && std::abs(vehicle_.wheel_speed()) < 0.4; ++i) step();
    ASSERT_GE(std::abs(vehicle_.wheel_speed()), 0.4);
  }
  void expect_halted_at_once(const std::string& reason) {
    EXPECT_EQ(command_.wheel_speed, 0.0);
    EXPECT_NE(driver_->reason().find(reason), std::string::npos) << driver_->reason();
    EXPECT_EQ(driver_->progress().stage, CalibrationStage::kAborted);
    encoders_ = scans_ = true;
    drive(4.0);
    EXPECT_EQ(vehicle_.wheel_speed(), 0.0);  // and it stays so
  }

  VehicleModel model_;
  SimulatedVehicle vehicle_;
  std::unique_ptr<CalibrationDriver> driver_;
  WheelCommand command_;
  bool encoders_ = true, scans_ = true;
};

TEST_F(Driven, DrivesAllArcsWithHaltsBetweenAndSteersAtRest) {
  std::vector<double> turns;
  double turned = 0.0;
  double fraction = 0.0;
  for (int i = 0; i < 20000 && !driver_->done(); ++i) {
    const Pose2 before = vehicle_.world_T_base();
    const double steering = vehicle_.steering();
    step();
    turned += angle_between(before.theta(), vehicle_.world_T_base().theta());
    if (vehicle_.wheel_speed() != 0.0) {
      EXPECT_NEAR(vehicle_.steering(), steering, 0.006);
    } else if (std::abs(turned) > 0.1) {
      turns.push_back(turned);
      turned = 0.0;
    }
    EXPECT_GE(driver_->progress().fraction, fraction);
    fraction = driver_->progress().fraction;
  }
  EXPECT_TRUE(driver_->done());
  EXPECT_EQ(fraction, 1.0);
  ASSERT_EQ(turns.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const bool left = i < 2 || i == 6 || i == 7;  // backwards to the right turns left
    EXPECT_NEAR(turns[i], left ? 1.0 : -1.0, 0.06) << i;
  }
}

TEST_F(Driven, HaltsInThePeriodInWhichItIsAborted) {
  drive_on_arc();
  driver_->abort("the user said so");
  step();
  expect_halted_at_once("the user said so");
}

TEST_F(Driven, HaltsWhenEncodersAreLost) {
  drive_on_arc();
  encoders_ = false;
  drive(0.4);
  expect_halted_at_once("no encoder readings");
}

TEST_F(Driven, HaltsWhenScansAreLost) {
  drive_on_arc();
  scans_ = false;
  drive(1.1);
  expect_halted_at_once("no scans that show anything");
}

TEST_F(Driven, HaltsWhereTheAreaEnds) {
  CalibrationPlan plan = short_plan();
  plan.max_distance = way_of(plan, model_.nominal).greatest_distance + 0.01;
  make(plan);
  for (int i = 0; i < 20000 && driver_->reason().empty() && !driver_->done(); ++i) {
    driver_->add(vehicle_.reading());
    driver_->add_scan(vehicle_.time(), 5);
    command_ = driver_->next(vehicle_.time());
    const WheelCommand farther{1.6 * command_.wheel_speed, 0.5 * command_.steering};
    vehicle_.drive(test::kControlPeriod, command_.wheel_speed != 0.0 ? farther : command_);
  }
  expect_halted_at_once("left the allowed area");
}

TEST_F(Driven, HaltsIfTheVehicleDoesNotObey) {
  for (int i = 0; i < 2000 && driver_->reason().empty(); ++i) {
    driver_->add(vehicle_.reading());
    driver_->add_scan(vehicle_.time(), 5);
    command_ = driver_->next(vehicle_.time());
    vehicle_.drive(test::kControlPeriod, WheelCommand{0.0, 0.0});
  }
  expect_halted_at_once("does not obey: steering");
}

TEST(CalibrationDriverTest, RefusesAPlanThatLeavesTheArea) {
  CalibrationPlan plan;
  plan.max_distance = 2.0;
  try {
    CalibrationDriver driver(plan, {});
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("max_distance = 2.00: the arcs lead"),
              std::string::npos)
        << error.what();
  }
}

TEST(CalibrationPlanTest, HasFourPhasesOfGrowingSteering) {
  const auto arcs = arcs_of({});
  ASSERT_EQ(arcs.size(), 24U);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    EXPECT_EQ(arcs[i].phase, kAllDrivePhases[i / 6]);
    EXPECT_EQ(arcs[i].wheel_speed > 0.0, is_forward(arcs[i].phase));
    if (i % 6 > 0) {
      EXPECT_GT(std::abs(arcs[i].steering), std::abs(arcs[i - 1].steering));
    }
  }
  EXPECT_NEAR(arcs.front().steering, 0.314, 1e-12);
  EXPECT_NEAR(arcs.back().steering, -0.873, 1e-12);
}

TEST(CalibrationPlanTest, RefusesWhatIsNoPlan) {
  CalibrationPlan plan;
  plan.arcs_per_phase = 1;
  EXPECT_THROW(validate(plan), std::invalid_argument);
  plan = {};
  plan.max_steering = plan.min_steering;
  EXPECT_THROW(validate(plan), std::invalid_argument);
  plan = {};
  plan.turn = std::nan("");
  EXPECT_THROW(validate(plan), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
