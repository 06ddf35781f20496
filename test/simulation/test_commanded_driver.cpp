// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/commanded_driver.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/simulated_worlds.hpp"
#include "support/times.hpp"

namespace falko_slam {
namespace {

using std::chrono::milliseconds;
using test::kBegin;

class CommandedDriverTest : public ::testing::Test {
 protected:
  void drive(int periods) {
    for (int i = 0; i < periods; ++i) {
      vehicle_.drive(test::kControlPeriod,
                     std::get<WheelCommand>(*driver_.next(vehicle_, test::kControlPeriod)));
    }
  }

  SimulatedVehicle vehicle_{VehicleModel(), {}, kBegin, 1};
  CommandedDriver driver_{milliseconds(500)};
};

TEST_F(CommandedDriverTest, StandsUntilItIsTold) {
  drive(50);
  EXPECT_EQ(vehicle_.world_T_base().translation().norm(), 0.0);
  EXPECT_FALSE(driver_.is_led(vehicle_.time()));
}

TEST_F(CommandedDriverTest, ObeysTheLastCommandAndHaltsWhenNoneComes) {
  driver_.command({0.5, 0.3}, vehicle_.time());
  driver_.command({-0.4, 0.2}, vehicle_.time());
  drive(25);
  EXPECT_LT(vehicle_.wheel_speed(), -0.2);
  EXPECT_NEAR(vehicle_.steering(), 0.2, 1e-9);
  drive(100);
  EXPECT_EQ(vehicle_.wheel_speed(), 0.0);
  EXPECT_NEAR(vehicle_.steering(), 0.2, 1e-9);
  EXPECT_FALSE(driver_.is_led(vehicle_.time()));
}

TEST_F(CommandedDriverTest, KeepsTheLastCommandIfOneIsNotFinite) {
  driver_.command({0.5, 0.0}, vehicle_.time());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(driver_.command({nan, 0.0}, vehicle_.time()), std::invalid_argument);
  EXPECT_THROW(driver_.command({0.0, 1.0 / 0.0}, vehicle_.time()), std::invalid_argument);
  drive(10);
  EXPECT_GT(vehicle_.wheel_speed(), 0.05);
}

}  // namespace
}  // namespace falko_slam
