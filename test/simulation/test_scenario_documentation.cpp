// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
// doc/scenarios.md against the code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/simulation/scenario_fields.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "support/field_values.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

const std::string& documentation() {
  static const std::string text = read_whole_file(FALKO_SLAM_SOURCE_DIR "/doc/scenarios.md");
  return text;
}

// The cell of the default in the row "| `name` | unit | default | ...".
std::string documented_default(const std::string& name) {
  const std::size_t row = documentation().find("\n| `" + name + "` | ");
  if (row == std::string::npos) return "";
  std::istringstream cells(documentation().substr(row + 3));
  std::string cell;
  for (int i = 0; i < 3; ++i) std::getline(cells, cell, '|');
  return cell;
}

void expect_documented(const std::map<std::string, std::string>& values) {
  for (const auto& [field, value] : values) {
    std::string name = field;
    std::replace(name.begin(), name.end(), '/', '.');
    const std::string cell = documented_default(name);
    ASSERT_FALSE(cell.empty()) << name;
    const auto yaml = YamlFields::of_text("is: " + value + "\nsaid: " + cell + "\n", name);
    if (value == "true" || value == "false") {
      EXPECT_EQ(yaml.at("said").flag(), yaml.at("is").flag()) << name;
    } else {
      const double number = yaml.at("is").number();
      EXPECT_NEAR(yaml.at("said").number(), number, 1e-9 * std::abs(number)) << name;
    }
  }
}

// `key` or `key: value`, alone or in a group.
bool is_documented(const std::string& key) {
  for (const std::string& text :
       {"`" + key + "`", "`" + key + ":", "{" + key + ":", ", " + key + ":"}) {
    if (documentation().find(text) != std::string::npos) return true;
  }
  return false;
}

// The names that the complaint about an unknown key offers.
std::vector<std::string> known_keys(const test::TemporaryFolder& folder, const std::string& text) {
  std::string list;
  try {
    read_scenario(folder.write("a.yaml", text));
  } catch (const std::runtime_error& error) {
    list = error.what();
  }
  const std::string begin = "known are ";
  const std::size_t place = list.find(begin);
  if (place == std::string::npos) ADD_FAILURE() << text << ": " << list;
  list = list.substr(std::min(list.size(), place + begin.size()));
  const std::size_t last = list.find(" and ");
  if (last != std::string::npos) list.replace(last, 5, ", ");
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream words(list);
  return {std::istream_iterator<std::string>(words), {}};
}

TEST(ScenarioDocumentation, HasEveryFieldWithItsDefault) {
  test::FieldValues laser;
  const LaserModel nav350;
  visit_laser_model_fields(nav350, laser);
  expect_documented(laser.values());
  test::FieldValues vehicle;
  const VehicleModel cb16;
  visit_vehicle_model_fields(cb16, vehicle);
  expect_documented(vehicle.values());
}

TEST(ScenarioDocumentation, HasEveryOtherKey) {
  const test::TemporaryFolder folder;
  const std::string drive = "world: []\ndrive:\n- ";
  for (const std::string& text :
       {std::string("world: []\n?: 1"),
        std::string("world: []\nsurfaces: {a: {reflectivity: 1, ?: 1}}"),
        std::string("world:\n- {wall: [[0, 0], [1, 0]], ?: 1}"),
        std::string("world:\n- box: {at: [0, 0], size: [1, 1], ?: 1}"),
        std::string("world:\n- column: {at: [0, 0], ?: 1}"),
        std::string("world:\n- {pallet: {at: [0, 0]}, repeat: {count: 1, step: [0, 0], ?: 1}}"),
        std::string("world:\n- {column: {}, moves: {through: [[0, 0]], ?: 1}}"),
        drive + "wait: {seconds: 1, ?: 1}", drive + "follow: {through: [[0, 0]], ?: 1}",
        drive + "arc: {wheel_speed: 1, way: 1, ?: 1}", drive + "{repeat: 1, steps: [], ?: 1}",
        std::string("world: []\nlaser: {?: 1}")}) {
    std::string unknown = text;
    unknown.replace(unknown.find('?'), 1, "unknown");
    for (const std::string& key : known_keys(folder, unknown)) {
      EXPECT_TRUE(is_documented(key)) << key;
    }
  }
}

TEST(ScenarioDocumentation, BeginsWithAScenarioOfTenLines) {
  const std::size_t begin = documentation().find("```yaml\n") + 8;
  const std::string text =
      documentation().substr(begin, documentation().find("```\n", begin) - begin);
  const test::TemporaryFolder folder;

  const Scenario scenario = read_scenario(folder.write("yard.yaml", text));

  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_EQ(scenario.world.fixed.faces.size(), 36U);
  EXPECT_EQ(scenario.world.fixed.cylinders.size(), 2U);
  EXPECT_EQ(scenario.drive.size(), 1U);
}

TEST(ScenarioDocumentation, NamesTheBuiltInSurfaces) {
  const test::TemporaryFolder folder;
  const Scenario scenario = read_scenario(folder.write("a.yaml", "world: []"));
  for (const Surface& surface : scenario.world.surfaces) {
    std::ostringstream words;
    words << "`" << surface.name << "` " << surface.reflectivity;
    EXPECT_NE(documentation().find(words.str()), std::string::npos) << words.str();
  }
}

}  // namespace
}  // namespace falko_slam
