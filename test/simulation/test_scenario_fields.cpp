// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/scenario_fields.hpp"

#include <gtest/gtest.h>

#include "support/field_values.hpp"

namespace falko_slam {
namespace {

using Values = std::map<std::string, std::string>;

Values values_of(const LaserModel& laser) {
  test::FieldValues values;
  visit_laser_model_fields(laser, values);
  return values.values();
}

Values values_of(const VehicleModel& vehicle) {
  test::FieldValues values;
  visit_vehicle_model_fields(vehicle, values);
  return values.values();
}

// A field that is new in a struct needs its name here, too.
TEST(ScenarioFields, AreAllThatTheModelsHave) {
  EXPECT_EQ(values_of(LaserModel()).size(), 20U);
  EXPECT_EQ(values_of(VehicleModel()).size(), 29U);
  EXPECT_EQ(values_of(LaserModel()).at("beams"), "1440");
  EXPECT_EQ(values_of(VehicleModel()).at("first_drive_ticks"), "4294900000");
}

TEST(ScenarioFields, CanAllBeChanged) {
  test::FieldChanger changer;
  LaserModel laser;
  visit_laser_model_fields(laser, changer);
  VehicleModel vehicle;
  visit_vehicle_model_fields(vehicle, changer);

  for (const auto& [name, value] : values_of(LaserModel())) {
    EXPECT_NE(values_of(laser).at(name), value) << name;
  }
  for (const auto& [name, value] : values_of(VehicleModel())) {
    EXPECT_NE(values_of(vehicle).at(name), value) << name;
  }
}

}  // namespace
}  // namespace falko_slam
