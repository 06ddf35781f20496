// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/scenario_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

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
  /// What is wrong, behind the name of the file.
  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      const std::string name = folder_.file("yard.yaml") + ": ";
      return what.rfind(name, 0) == 0 ? what.substr(name.size()) : "no file in: " + what;
    }
    return "no error";
  }
  /// Of a thing of the world.
  std::string thing_error(const std::string& thing) const {
    return error_of("world:\n- " + thing + "\n");
  }
  std::string step_error(const std::string& step) const {
    return error_of("world: []\ndrive:\n- " + step + "\n");
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

TEST_F(ScenarioFile, RefusesWhatItCannotUnderstand) {
  EXPECT_EQ(error_of(""), "is empty");
  EXPECT_EQ(error_of("- 1"), "line 1: must be a group of fields (name: value)");
  EXPECT_EQ(error_of("name: x"), "line 1: world is missing");
  EXPECT_EQ(error_of("world: {a: 1}"), "line 1: world: must be a list");
  EXPECT_EQ(error_of("world: []\nname: [a]"), "line 2: name: must be a text");
  EXPECT_EQ(error_of("world: []\nstart: 3"), "line 2: start: must be [x, y, heading] or [x, y]");
  EXPECT_EQ(error_of("world: []\nstart: [1, .nan, 3]"),
            "line 2: start[1]: must be a number in [-10000, 10000]");
  EXPECT_EQ(
      error_of("world: []\nwrold: []"),
      "line 2: wrold: nobody knows this; known are name, start, surfaces, scatter_seed, world, "
      "vehicle, laser and drive");
  EXPECT_EQ(error_of("world: []\nscatter_seed: -1"),
            "line 2: scatter_seed: must be a whole number of at least 0");
  EXPECT_EQ(error_of("world: []\nsurfaces: [a]"),
            "line 2: surfaces: must be a group of fields (name: value)");
  EXPECT_EQ(error_of("world: []\nsurfaces:\n  brick:\n    retro_gain: 1"),
            "line 3: surfaces.brick: reflectivity is missing");
  EXPECT_EQ(error_of("world: []\nsurfaces:\n  brick: {reflectivity: 3}"),
            "line 3: surfaces.brick.reflectivity: must be a number in [0, 2]");
  EXPECT_EQ(
      error_of("world: []\nsurfaces:\n  brick: {reflectivity: 1, colour: red}"),
      "line 3: surfaces.brick.colour: nobody knows this; known are reflectivity and retro_gain");
}

TEST_F(ScenarioFile, RefusesThings) {
  const std::string kinds = "wall, polygon, box, pallet, column and reflector";
  EXPECT_EQ(thing_error("surface: white"), "line 2: world[0]: must have one of " + kinds);
  EXPECT_EQ(thing_error("{wall: [[0, 0], [1, 0]], box: {}}"),
            "line 2: world[0]: has wall and box, must have one of them only");
  EXPECT_EQ(thing_error("wall"), "line 2: world[0]: must be a group of fields (name: value)");
  EXPECT_EQ(thing_error("wall: 5"), "line 2: world[0].wall: must be a list of points [x, y]");
  EXPECT_EQ(thing_error("wall: [[0, 0]]"),
            "line 2: world[0].wall: must have at least 2 points [x, y]");
  EXPECT_EQ(thing_error("wall:\n  - [0, 0]\n  - [0, 0, 1]"),
            "line 4: world[0].wall[1]: must be two numbers");
  EXPECT_EQ(thing_error("wall: [[0, 0], [1, 1], [1, 1]]"),
            "line 2: world[0].wall[2]: is where the point before it is");
  EXPECT_EQ(thing_error("polygon: [[0, 0], [1, 0]]"),
            "line 2: world[0].polygon: must have at least 3 points [x, y]");
  EXPECT_EQ(thing_error("polygon: [[0, 0], [1, 0], [1, 1], [0, 0]]"),
            "line 2: world[0].polygon: ends where it begins");
  EXPECT_EQ(thing_error("{wall: [[0, 0], [1, 0], [2, 1]], closed: 1}"),
            "line 2: world[0].closed: must be true or false");
  EXPECT_EQ(thing_error("{polygon: [[0, 0], [1, 0], [2, 1]], closed: true}")
                .rfind("line 2: world[0].closed: nobody knows this", 0),
            0U);
  EXPECT_EQ(thing_error("box: {size: [1, 1]}"), "line 2: world[0].box: at is missing");
  EXPECT_EQ(thing_error("box: {at: [0, 0]}"), "line 2: world[0].box: size is missing");
  EXPECT_EQ(thing_error("box:\n    at: [0, 0]\n    size: 3"),
            "line 4: world[0].box.size: must be two numbers");
  EXPECT_EQ(thing_error("box: {at: [0, 0], size: [1, 0]}"),
            "line 2: world[0].box.size[1]: must be a number in [0.001, 1000]");
  EXPECT_EQ(thing_error("box: {at: [0, 0], size: [1, 1], height: 2}"),
            "line 2: world[0].box.height: nobody knows this; known are at, size and bulge");
  EXPECT_EQ(thing_error("pallet: {at: [1, 2, 3, 4]}"),
            "line 2: world[0].pallet.at: must be [x, y, heading] or [x, y]");
  EXPECT_EQ(thing_error("column: {at: [0, 0], radius: -1}"),
            "line 2: world[0].column.radius: must be a number in [0.001, 1000]");
  EXPECT_EQ(thing_error("reflector: {at: here}"),
            "line 2: world[0].reflector.at: must be two numbers");
  EXPECT_EQ(thing_error("{reflector: {at: [0, 0]}, surface: gold}"),
            "line 2: world[0].surface: there is no such surface; there are white, concrete, wood, "
            "steel, cardboard, dark, glass, reflector");
  EXPECT_EQ(thing_error("{pallet: {at: [0, 0]}, repeat: {count: 99999, step: [1, 0]}}"),
            "line 2: world[0].repeat.count: must be a whole number in [1, 10000]");
  EXPECT_EQ(thing_error("{pallet: {at: [0, 0]}, repeat: {count: 10000, step: [1, 0]}}\n"
                        "- {polygon: [[0, 0], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1]], "
                        "repeat: {count: 10000, step: [1, 0]}}"),
            "line 3: world[1]: makes more than 100000 faces and cylinders of the world");
}

TEST_F(ScenarioFile, RefusesMotions) {
  const std::string box = "box: {at: [0, 0], size: [1, 1]}\n  ";
  EXPECT_EQ(thing_error(box + "moves: {speed: 1}"), "line 3: world[0].moves: through is missing");
  EXPECT_EQ(thing_error(box + "moves: {through: []}"),
            "line 3: world[0].moves.through: must have at least 1 places [x, y, heading]");
  EXPECT_EQ(thing_error(box + "moves: {through: [[1]]}"),
            "line 3: world[0].moves.through[0]: must be [x, y, heading] or [x, y]");
  EXPECT_EQ(thing_error(box + "moves: {through: [[1, 2]], speed: 0}"),
            "line 3: world[0].moves.speed: must be a number in [0.01, 20]");
  EXPECT_EQ(thing_error(box + "moves: {through: [[1, 2]], repeat: twice}"),
            "line 3: world[0].moves.repeat: must be once, round or back_and_forth");
  EXPECT_EQ(thing_error(box + "moves: {through: [[1, 2]], rest: 1}"),
            "line 3: world[0].moves.rest: nobody knows this; known are through, speed and repeat");
  EXPECT_EQ(thing_error(box + "appears: -1"),
            "line 3: world[0].appears: must be a number in [0, 1000000000]");
  EXPECT_EQ(thing_error(box + "appears: 5\n  disappears: 4"),
            "line 4: world[0].disappears: must be a number of at least 5");
}

TEST_F(ScenarioFile, RefusesVehiclesAndLasers) {
  const auto begins = [this](const std::string& text, const std::string& error) {
    EXPECT_EQ(error_of("world: []\n" + text).rfind(error, 0), 0U) << error_of("world: []\n" + text);
  };
  begins("vehicle:\n  tricycle:\n    wheelbase: 0", "line 4: vehicle.tricycle.wheelbase = 0: must");
  begins("vehicle:\n  tricycle:\n    wheel: 0", "line 4: vehicle.tricycle.wheel: nobody knows");
  begins("vehicle:\n  encoder_rate: fast", "line 3: vehicle.encoder_rate: must be a number");
  begins("vehicle:\n  encoders: {steer_zero: 70000}",
         "line 3: vehicle.encoders.steer_zero = 70000");
  begins("vehicle:\n  first_drive_ticks: 4294967296",
         "line 3: vehicle.first_drive_ticks: must be a whole number in [0, 4294967295]");
  begins("vehicle: cb16", "line 2: vehicle: must be a group");
  begins("laser:\n  range_noise: -1", "line 3: laser.range_noise = -1: must be in [0, 1]");
  begins("laser:\n  angle_increment: 0", "line 3: laser.angle_increment without sign = 0: must");
  begins("laser:\n  beams: 1.5", "line 3: laser.beams: must be a whole number of at least 0");
  begins("laser:\n  like: lms511", "line 3: laser.like: must be nav350 or s300");
  begins("laser:\n  noise: 1", "line 3: laser.noise: nobody knows this; known are like, beams, ");
}

TEST_F(ScenarioFile, RefusesSteps) {
  EXPECT_EQ(error_of("world: []\ndrive: {wait: 1}"), "line 2: drive: must be a list");
  EXPECT_EQ(step_error("halt: 1"),
            "line 3: drive[0]: must have one of wait, follow, arc and repeat");
  EXPECT_EQ(step_error("{wait: {seconds: 1}, arc: {}}"),
            "line 3: drive[0]: has wait and arc, must have one of them only");
  EXPECT_EQ(step_error("{wait: {seconds: 1}, then: 2}").rfind("line 3: drive[0].then: nobody", 0),
            0U);
  EXPECT_EQ(step_error("wait: 2"),
            "line 3: drive[0].wait: must be a group of fields (name: value)");
  EXPECT_EQ(step_error("wait: {seconds: -1}"),
            "line 3: drive[0].wait.seconds: must be a number in [0, 86400]");
  EXPECT_EQ(step_error("follow: {speed: 1}"), "line 3: drive[0].follow: through is missing");
  EXPECT_EQ(step_error("follow: {through: []}"),
            "line 3: drive[0].follow.through: must have at least 1 points [x, y]");
  EXPECT_EQ(step_error("follow: {through: [[1, 2]], speed: 1.6}"),
            "line 3: drive[0].follow.speed: must be a number in [0.01, 1.5]");
  EXPECT_EQ(step_error("follow: {through: [[1, 2]], corner_radius: -1}"),
            "line 3: drive[0].follow.corner_radius: must be a number in [0, 1000]");
  EXPECT_EQ(step_error("follow: {through: [[1, 2]], backward: yes}"),
            "line 3: drive[0].follow.backward: must be true or false");
  EXPECT_EQ(step_error("arc: {wheel_speed: 1}"),
            "line 3: drive[0].arc: must have one of turn and way");
  EXPECT_EQ(step_error("arc: {wheel_speed: 1, way: 1, turn: 1}"),
            "line 3: drive[0].arc: has turn and way, must have one of them only");
  EXPECT_EQ(step_error("arc: {wheel_speed: 0, way: 1}"),
            "line 3: drive[0].arc.wheel_speed: must be at least 0.01 forwards or backwards");
  EXPECT_EQ(step_error("arc: {wheel_speed: 2, way: 1}"),
            "line 3: drive[0].arc.wheel_speed: must be a number in [-1.5, 1.5]");
  EXPECT_EQ(step_error("arc: {wheel_speed: 1, steering: 2, turn: 1}")
                .rfind("line 3: drive[0].arc.steering: must be a number in [-1.39626", 0),
            0U);
  EXPECT_EQ(step_error("arc: {wheel_speed: 1, turn: 1}"),
            "line 3: drive[0].arc.turn: never ends: there is no steering");
  EXPECT_EQ(step_error("repeat: 2"), "line 3: drive[0]: steps is missing");
  EXPECT_EQ(step_error("repeat: 0\n  steps: []"),
            "line 3: drive[0].repeat: must be a whole number in [1, 100000]");
  EXPECT_EQ(step_error("repeat: 2\n  steps:\n  - wait: {seconds: x}"),
            "line 5: drive[0].steps[0].wait.seconds: must be a number in [0, 86400]");
  EXPECT_EQ(
      step_error("repeat: 1000\n  steps:\n  - repeat: 1000\n    steps: [{wait: {seconds: 1}}]"),
      "line 3: drive[0]: makes a drive of more than 100000 steps");
}

TEST_F(ScenarioFile, NamesAFileThatIsNotThere) {
  EXPECT_THROW(read_scenario(folder_.file("none.yaml")), std::runtime_error);
}

}  // namespace
}  // namespace falko_slam
