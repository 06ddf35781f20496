// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/scenario_file.hpp"

#include <filesystem>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/simulation/scenario_fields.hpp"
#include "scenario_drive.hpp"
#include "scenario_values.hpp"
#include "scenario_world.hpp"

namespace falko_slam {
namespace {

enum class Known { kNav350, kS300 };

LaserModel read_laser(YamlFields& scenario) {
  static const EnumNames<Known> names = {{"nav350", Known::kNav350}, {"s300", Known::kS300}};
  Known like = Known::kNav350;
  scenario.begin("laser");
  scenario.choice("like", like, names);
  LaserModel laser = like == Known::kS300 ? s300() : LaserModel();
  visit_laser_model_fields(laser, scenario);
  scenario.check([&] { validate(laser); });
  scenario.refuse_unknown();
  scenario.end();
  return laser;
}

VehicleModel read_vehicle(YamlFields& scenario) {
  VehicleModel vehicle;
  scenario.begin("vehicle");
  visit_vehicle_model_fields(vehicle, scenario);
  scenario.check([&] { validate(vehicle); });
  scenario.refuse_unknown();
  scenario.end();
  return vehicle;
}

}  // namespace

void validate(const WorldVariation& variation) {
  require_in_range("scatter", variation.scatter, 0.0, 100.0);
  require_in_range("bulge", variation.bulge, 0.0, 100.0);
}

Scenario read_scenario(const std::string& path, const WorldVariation& variation) {
  validate(variation);
  YamlFields fields(path);
  Scenario scenario;
  scenario.name = std::filesystem::path(path).stem().string();
  fields.field("name", scenario.name);
  if (const auto start = fields.find("start")) scenario.world_T_start = read_pose(*start);
  scenario.world = read_world(fields, variation);
  scenario.vehicle = read_vehicle(fields);
  scenario.laser = read_laser(fields);
  scenario.drive = read_drive(fields, scenario.vehicle.actuators);
  fields.refuse_unknown();
  return scenario;
}

}  // namespace falko_slam
