// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/scenario_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <variant>

#include "falko_slam/simulation/scenario_fields.hpp"
#include "support/field_values.hpp"
#include "support/poses.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class ScenarioFile : public ::testing::Test {
 protected:
  Scenario read(const std::string& text) const {
    return read_scenario(folder_.write("yard.yaml", text));
  }
  static std::size_t surface(const Scenario& scenario, const std::string& name) {
    const auto& surfaces = scenario.world.surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i].name == name) return i;
    }
    return surfaces.size();
  }

  test::TemporaryFolder folder_;
};

void expect_face(const Face& face, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  EXPECT_TRUE(face.from.isApprox(from, 1e-12)) << face.from.transpose();
  EXPECT_TRUE(face.to.isApprox(to, 1e-12)) << face.to.transpose();
}

template <class Model>
std::map<std::string, std::string> values_of(const Model& model) {
  test::FieldValues values;
  if constexpr (std::is_same_v<Model, LaserModel>) visit_laser_model_fields(model, values);
  if constexpr (std::is_same_v<Model, VehicleModel>) visit_vehicle_model_fields(model, values);
  return values.values();
}

TEST_F(ScenarioFile, LeavesTheDefaultsOfTheModels) {
  const Scenario scenario = read("world:\n");
  EXPECT_EQ(scenario.name, "yard");
  test::expect_near(scenario.world_T_start, {0.0, 0.0, 0.0}, 1e-12);
  EXPECT_EQ(values_of(scenario.vehicle), values_of(VehicleModel()));
  EXPECT_EQ(values_of(scenario.laser), values_of(LaserModel()));
  EXPECT_TRUE(scenario.world.fixed.faces.empty());
  EXPECT_TRUE(scenario.world.fixed.cylinders.empty());
  EXPECT_TRUE(scenario.world.bodies.empty());
  EXPECT_TRUE(scenario.drive.empty());
}

TEST_F(ScenarioFile, ReadsNameStartAndSurfaces) {
  const Scenario scenario = read(
      "name: a yard\nstart: [1, 2, deg(90)]\nworld: []\n"
      "surfaces:\n  brick: {reflectivity: 0.35}\n  dark: {reflectivity: 0.02, retro_gain: 3}\n");
  EXPECT_EQ(scenario.name, "a yard");
  test::expect_near(scenario.world_T_start, {1.0, 2.0, 0.5 * kPi}, 1e-12);
  const auto& surfaces = scenario.world.surfaces;
  EXPECT_EQ(surfaces.at(surface(scenario, "brick")).reflectivity, 0.35);
  EXPECT_EQ(surfaces.at(surface(scenario, "brick")).retro_gain, 0.0);
  EXPECT_EQ(surfaces.at(surface(scenario, "dark")).reflectivity, 0.02);
  EXPECT_EQ(surfaces.at(surface(scenario, "dark")).retro_gain, 3.0);
  EXPECT_EQ(surfaces.at(surface(scenario, "white")).reflectivity, 1.0);
  for (const char* name : {"concrete", "wood", "steel", "cardboard", "dark", "reflector"}) {
    EXPECT_LT(surface(scenario, name), surfaces.size()) << name;
  }
  EXPECT_GT(surfaces.at(surface(scenario, "reflector")).retro_gain, 10.0);
}

TEST_F(ScenarioFile, ReadsWallsAndPolygons) {
  const Scenario scenario = read(
      "world:\n- wall: [[0, 0], [4, 0], [4, 3]]\n- {wall: [[0, 0], [1, 0], [1, 1]], closed: true, "
      "surface: steel}\n- polygon: [[5, 5], [6, 5], [6, 6]]\n");
  const auto& faces = scenario.world.fixed.faces;
  ASSERT_EQ(faces.size(), 8U);
  expect_face(faces[0], {0.0, 0.0}, {4.0, 0.0});
  expect_face(faces[1], {4.0, 0.0}, {4.0, 3.0});
  expect_face(faces[4], {1.0, 1.0}, {0.0, 0.0});
  expect_face(faces[7], {6.0, 6.0}, {5.0, 5.0});
  EXPECT_EQ(faces[0].surface, surface(scenario, "concrete"));
  EXPECT_EQ(faces[4].surface, surface(scenario, "steel"));
  EXPECT_EQ(faces[7].surface, surface(scenario, "concrete"));
}

TEST_F(ScenarioFile, ReadsBoxesPalletsColumnsAndReflectors) {
  const Scenario scenario = read(
      "world:\n- box: {at: [1, 2, deg(90)], size: [4, 2]}\n- pallet: {at: [10, 0]}\n"
      "- column: {at: [3, 4], radius: 0.25}\n- reflector: {at: [5, 6]}\n"
      "- {reflector: {at: [5, 7], radius: 0.05}, surface: white}\n");
  const auto& faces = scenario.world.fixed.faces;
  ASSERT_EQ(faces.size(), 8U);
  expect_face(faces[0], {2.0, 0.0}, {2.0, 4.0});
  expect_face(faces[4], {9.4, -0.4}, {10.6, -0.4});
  EXPECT_EQ(faces[4].surface, surface(scenario, "cardboard"));
  const auto& cylinders = scenario.world.fixed.cylinders;
  ASSERT_EQ(cylinders.size(), 3U);
  EXPECT_EQ(cylinders[0].center, Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(cylinders[0].radius, 0.25);
  EXPECT_EQ(cylinders[0].surface, surface(scenario, "concrete"));
  EXPECT_EQ(cylinders[1].radius, 0.04);
  EXPECT_EQ(cylinders[1].surface, surface(scenario, "reflector"));
  EXPECT_EQ(cylinders[2].radius, 0.05);
  EXPECT_EQ(cylinders[2].surface, surface(scenario, "white"));
}

TEST_F(ScenarioFile, RepeatsThings) {
  const Scenario scenario = read(
      "world:\n- {wall: [[1, 0], [2, 0]], repeat: {count: 2, step: [0, 1, deg(90)]}}\n"
      "- reflector: {at: [0, 0]}\n  repeat: [{count: 2, step: [1, 0]}, {count: 2, step: [0, 3]}]\n"
      "  without: [1]\n");
  const auto& faces = scenario.world.fixed.faces;
  ASSERT_EQ(faces.size(), 2U);
  expect_face(faces[1], {1.0, 1.0}, {1.0, 2.0});  // turned about its first point
  const auto& cylinders = scenario.world.fixed.cylinders;
  ASSERT_EQ(cylinders.size(), 3U);
  EXPECT_EQ(cylinders[1].center, Eigen::Vector2d(0.0, 3.0));
  EXPECT_EQ(cylinders[2].center, Eigen::Vector2d(1.0, 3.0));
}

TEST_F(ScenarioFile, ScattersByItsOwnSeedAlone) {
  const std::string things =
      "world:\n- {column: {at: [0, 0]}, scatter: [0.1, 0.1, 0]}\n"
      "- {column: {at: [0, 0]}, scatter: [0.1, 0.1, 0]}\n";
  const auto first = read(things).world.fixed.cylinders;
  const auto again = read("scatter_seed: 1\n" + things).world.fixed.cylinders;
  const auto other = read("scatter_seed: 2\n" + things).world.fixed.cylinders;
  EXPECT_EQ(first[0].center, again[0].center);
  EXPECT_NE(first[0].center, first[1].center);
  EXPECT_NE(first[0].center, other[0].center);
}

TEST_F(ScenarioFile, ReadsWhatMoves) {
  const Scenario scenario = read(
      "world:\n- column: {radius: 0.1}\n  repeat: {count: 2, step: [0, 0.3]}\n"
      "  moves: {through: [[1, 2, 0], [3, 2, deg(180)]], speed: 0.5, repeat: back_and_forth}\n"
      "- {box: {at: [0.2, 0], size: [1, 1]}, moves: {through: [[1, 1]]}}\n");
  EXPECT_TRUE(scenario.world.fixed.cylinders.empty());
  ASSERT_EQ(scenario.world.bodies.size(), 2U);
  const Body& person = scenario.world.bodies[0];
  ASSERT_EQ(person.shape.cylinders.size(), 2U);
  EXPECT_EQ(person.shape.cylinders[1].center, Eigen::Vector2d(0.0, 0.3));
  ASSERT_EQ(person.motion.through.size(), 2U);
  test::expect_near(person.motion.through[1], {3.0, 2.0, -kPi}, 1e-12);
  EXPECT_EQ(person.motion.speed, 0.5);
  EXPECT_EQ(person.motion.repeat, BodyMotion::Repeat::kBackAndForth);
  EXPECT_EQ(person.appears, 0.0);
  EXPECT_EQ(person.disappears, kInfinity);
  const Body& box = scenario.world.bodies[1];
  EXPECT_EQ(box.motion.speed, BodyMotion().speed);
  EXPECT_EQ(box.motion.repeat, BodyMotion::Repeat::kOnce);
  EXPECT_NEAR(box.shape.faces[0].from.x(), -0.3, 1e-12);
}

TEST_F(ScenarioFile, ReadsWhatIsThereForATime) {
  const Scenario scenario = read(
      "world:\n- {pallet: {at: [4, 5]}, appears: 10, disappears: 20}\n"
      "- {wall: [[1, 0], [2, 0]], appears: 5, disappears: .inf}\n");
  ASSERT_EQ(scenario.world.bodies.size(), 2U);
  EXPECT_TRUE(scenario.world.fixed.faces.empty());
  const Body& pallet = scenario.world.bodies[0];
  EXPECT_EQ(pallet.appears, 10.0);
  EXPECT_EQ(pallet.disappears, 20.0);
  test::expect_near(pose_at(pallet.motion, 15.0), {0.0, 0.0, 0.0}, 1e-12);
  expect_face(pallet.shape.faces[0], {3.4, 4.6}, {4.6, 4.6});
  const Body& wall = scenario.world.bodies[1];
  EXPECT_EQ(wall.disappears, kInfinity);
  expect_face(wall.shape.faces[0], {1.0, 0.0}, {2.0, 0.0});
}

TEST_F(ScenarioFile, ReadsVehicleAndLaser) {
  const Scenario scenario = read(
      "world: []\nvehicle:\n  tricycle: {wheelbase: 1.2, steer_offset_forward: deg(-1)}\n"
      "  base_T_laser: {x: 0.5, theta: 0.1}\n  nominal_base_T_laser: {y: 0.2}\n"
      "  encoders: {steer_ticks_per_turn: 4096}\n  first_drive_ticks: 12\n"
      "  actuators: {max_wheel_speed: 2}\n  errors: {slip_per_run: 0.01}\n"
      "laser:\n  like: s300\n  range_noise: 0.02\n");
  const VehicleModel& vehicle = scenario.vehicle;
  EXPECT_EQ(vehicle.tricycle.wheelbase, 1.2);
  EXPECT_NEAR(vehicle.tricycle.steer_offset_forward, degrees_to_radians(-1.0), 1e-15);
  EXPECT_EQ(vehicle.tricycle.driving_scale, VehicleModel().tricycle.driving_scale);
  test::expect_near(vehicle.base_T_laser, {0.5, VehicleModel().base_T_laser.y(), 0.1}, 1e-12);
  test::expect_near(vehicle.nominal_base_T_laser, {0.39, 0.2, 0.0}, 1e-12);
  EXPECT_EQ(vehicle.encoders.steer_ticks_per_turn, 4096U);
  EXPECT_EQ(vehicle.first_drive_ticks, 12U);
  EXPECT_EQ(vehicle.actuators.max_wheel_speed, 2.0);
  EXPECT_EQ(vehicle.errors.slip_per_run, 0.01);
  LaserModel laser = s300();
  laser.range_noise = 0.02;
  EXPECT_EQ(values_of(scenario.laser), values_of(laser));
  EXPECT_EQ(values_of(read("world: []\nlaser: {like: nav350}").laser), values_of(LaserModel()));
}

TEST_F(ScenarioFile, ReadsTheDrive) {
  const Scenario scenario = read(
      "world: []\ndrive:\n- wait: {seconds: 2}\n"
      "- follow: {through: [[1, 0], [2, 3]], speed: 1, corner_radius: 2, backward: true}\n"
      "- arc: {wheel_speed: -0.5, steering: deg(30), turn: deg(180)}\n"
      "- arc: {wheel_speed: 1, way: 3}\n"
      "- repeat: 2\n  steps:\n  - wait: {seconds: 1}\n  - repeat: 3\n    steps:\n    - follow: "
      "{through: [[0, 0]]}\n");
  ASSERT_EQ(scenario.drive.size(), 12U);
  EXPECT_EQ(std::get<WaitStep>(scenario.drive[0]).seconds, 2.0);
  const auto follow = std::get<FollowStep>(scenario.drive[1]);
  ASSERT_EQ(follow.through.size(), 2U);
  EXPECT_EQ(follow.through[1], Eigen::Vector2d(2.0, 3.0));
  EXPECT_EQ(follow.speed, 1.0);
  EXPECT_EQ(follow.corner_radius, 2.0);
  EXPECT_TRUE(follow.backward);
  const auto turn = std::get<ArcStep>(scenario.drive[2]);
  EXPECT_EQ(turn.wheel_speed, -0.5);
  EXPECT_NEAR(turn.steering, kPi / 6.0, 1e-12);
  EXPECT_NEAR(turn.turn, kPi, 1e-12);
  EXPECT_EQ(turn.way, 0.0);
  const auto straight = std::get<ArcStep>(scenario.drive[3]);
  EXPECT_EQ(straight.steering, 0.0);
  EXPECT_EQ(straight.turn, 0.0);
  EXPECT_EQ(straight.way, 3.0);
  EXPECT_TRUE(std::holds_alternative<WaitStep>(scenario.drive[8]));
  const auto usual = std::get<FollowStep>(scenario.drive[11]);
  EXPECT_EQ(usual.speed, FollowStep().speed);
  EXPECT_EQ(usual.corner_radius, FollowStep().corner_radius);
  EXPECT_FALSE(usual.backward);
}

}  // namespace
}  // namespace falko_slam
