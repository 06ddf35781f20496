// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "falko_slam/simulation/scenario_file.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class ScenarioFileRefusal : public ::testing::Test {
 protected:
  /// What is wrong, behind the name of the file.
  std::string error_of(const std::string& text) const {
    try {
      read_scenario(folder_.write("yard.yaml", text));
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

  test::TemporaryFolder folder_;
};

TEST_F(ScenarioFileRefusal, OfWhatItCannotUnderstand) {
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

TEST_F(ScenarioFileRefusal, OfThings) {
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

TEST_F(ScenarioFileRefusal, OfMotions) {
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

TEST_F(ScenarioFileRefusal, OfVehiclesAndLasers) {
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

TEST_F(ScenarioFileRefusal, OfSteps) {
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

TEST_F(ScenarioFileRefusal, NamesAFileThatIsNotThere) {
  const std::string path = folder_.file("none.yaml");
  try {
    read_scenario(path);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).rfind(path + ": ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
