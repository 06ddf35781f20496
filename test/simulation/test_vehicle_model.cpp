// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/vehicle_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace falko_slam {
namespace {

std::string complaint_about(const std::function<void(VehicleModel&)>& change) {
  VehicleModel vehicle;
  change(vehicle);
  try {
    validate(vehicle);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(VehicleModel, IsValidByDefault) { EXPECT_NO_THROW(validate(VehicleModel())); }

TEST(VehicleModel, IsRefusedWithTheFieldAndItsValue) {
  using Change = std::function<void(VehicleModel&)>;
  const auto begins = [](const std::string& text, const Change& change) {
    EXPECT_EQ(complaint_about(change).find(text), 0U) << complaint_about(change);
  };
  const double nan = std::nan("");
  begins("tricycle.wheelbase = 0: ", [](auto& v) { v.tricycle.wheelbase = 0.0; });
  begins("nominal.driving_scale = -1: ", [](auto& v) { v.nominal.driving_scale = -1.0; });
  begins("base_T_laser.x = 50: ", [](auto& v) { v.base_T_laser = {50.0, 0.0, 0.0}; });
  begins("nominal_base_T_laser.y = nan: ", [=](auto& v) {
    v.nominal_base_T_laser = {0.0, nan, 0.0};
  });
  begins("encoders.steer_ticks_per_turn = 0: ",
         [](auto& v) { v.encoders.steer_ticks_per_turn = 0; });
  begins("encoder_rate = 0: ", [](auto& v) { v.encoder_rate = 0.0; });
  begins("actuators.max_wheel_speed = 0: ", [](auto& v) { v.actuators.max_wheel_speed = 0.0; });
  begins("actuators.acceleration = 0: ", [](auto& v) { v.actuators.acceleration = 0.0; });
  begins("actuators.max_steering = 4: ", [](auto& v) { v.actuators.max_steering = 4.0; });
  begins("actuators.steer_rate = 0: ", [](auto& v) { v.actuators.steer_rate = 0.0; });
  begins("actuators.command_timeout = 0: ", [](auto& v) { v.actuators.command_timeout = 0.0; });
  begins("errors.slip_per_run = -1: ", [](auto& v) { v.errors.slip_per_run = -1.0; });
  begins("errors.slip_per_phase = 1: ", [](auto& v) { v.errors.slip_per_phase = 1.0; });
  begins("errors.slip_per_root_metre = 1: ", [](auto& v) { v.errors.slip_per_root_metre = 1.0; });
  begins("errors.steering_per_run = nan: ", [=](auto& v) { v.errors.steering_per_run = nan; });
  begins("errors.steering_per_phase = -1: ", [](auto& v) { v.errors.steering_per_phase = -1.0; });
}

}  // namespace
}  // namespace falko_slam
