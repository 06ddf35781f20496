// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/laser_model.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace falko_slam {
namespace {

std::string complaint_about(const std::function<void(LaserModel&)>& change) {
  LaserModel laser;
  change(laser);
  try {
    validate(laser);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(LaserModel, IsValidByDefaultAndAsAnS300) {
  EXPECT_NO_THROW(validate(LaserModel()));
  EXPECT_NO_THROW(validate(s300()));
}

TEST(LaserModel, MayTurnClockwise) {
  EXPECT_EQ(complaint_about([](LaserModel& laser) { laser.angle_increment *= -1.0; }), "");
}

TEST(LaserModel, S300LooksSymmetricallyToTheFront) {
  const LaserModel laser = s300();
  const double last =
      laser.angle_min + static_cast<double>(laser.beams - 1) * laser.angle_increment;
  EXPECT_NEAR(last, -laser.angle_min, 1e-12);
  EXPECT_NEAR(last, degrees_to_radians(135.0), 1e-12);
  EXPECT_FALSE(laser.intensities);
}

TEST(LaserModel, IsRefusedWithTheFieldAndItsValue) {
  const auto begins = [](const std::string& text, const std::function<void(LaserModel&)>& change) {
    EXPECT_EQ(complaint_about(change).find(text), 0U) << complaint_about(change);
  };
  const double nan = std::nan("");
  begins("beams = 1: must be in [2, ", [](LaserModel& l) { l.beams = 1; });
  begins("angle_min = 7: ", [](LaserModel& l) { l.angle_min = 7.0; });
  begins("angle_increment = 0.1: ", [](LaserModel& l) { l.angle_increment = 0.1; });
  begins("angle_increment = nan: ", [=](LaserModel& l) { l.angle_increment = nan; });
  begins("angle_increment without sign = 0: ", [](LaserModel& l) { l.angle_increment = 0.0; });
  begins("scan_period = 0: ", [](LaserModel& l) { l.scan_period = 0.0; });
  begins("time_increment = 0.125: ", [](LaserModel& l) { l.time_increment = 0.125; });
  begins("nearest = -1: ", [](LaserModel& l) { l.nearest = -1.0; });
  begins("farthest = 0.1: ", [](LaserModel& l) { l.farthest = 0.1; });
  begins("range_of_dark = 0: ", [](LaserModel& l) { l.range_of_dark = 0.0; });
  begins("beam_diameter = -1: ", [](LaserModel& l) { l.beam_diameter = -1.0; });
  begins("beam_divergence = 1: ", [](LaserModel& l) { l.beam_divergence = 1.0; });
  begins("echo_separation = -1: ", [](LaserModel& l) { l.echo_separation = -1.0; });
  begins("range_noise = nan: ", [=](LaserModel& l) { l.range_noise = nan; });
  begins("range_step = -0.1: ", [](LaserModel& l) { l.range_step = -0.1; });
  begins("bearing_noise = 1: ", [](LaserModel& l) { l.bearing_noise = 1.0; });
  begins("drop_out = 2: ", [](LaserModel& l) { l.drop_out = 2.0; });
  begins("white_intensity = -1: ", [](LaserModel& l) { l.white_intensity = -1.0; });
  begins("intensity_exponent = 0: ", [](LaserModel& l) { l.intensity_exponent = 0.0; });
  begins("stated_range_min = -1: ", [](LaserModel& l) { l.stated_range_min = -1.0; });
  begins("stated_range_max = 0: ", [](LaserModel& l) { l.stated_range_max = 0.0; });
}

}  // namespace
}  // namespace falko_slam
