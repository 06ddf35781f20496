// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/simulation_node_params.hpp"

#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "support/field_values.hpp"
#include "support/refusals.hpp"

namespace falko_slam {
namespace {

SimulationNodeParams read_simulation(XmlRpc::XmlRpcValue tree,
                                     std::vector<std::string>* unknown = nullptr) {
  std::vector<std::string> names;
  return read_simulation_node_params(tree, "/simulator", unknown ? *unknown : names);
}

XmlRpc::XmlRpcValue with_scenario() {
  XmlRpc::XmlRpcValue tree;
  tree["scenario"] = "yard.yaml";
  return tree;
}

std::map<std::string, std::string> values_of(const SimulationNodeParams& params) {
  test::FieldValues values;
  visit_simulation_node_fields(params, values);
  return values.values();
}

TEST(ShippedSimulatorYaml, HoldsTheDefaultsOfEveryField) {
  const XmlRpc::XmlRpcValue tree =
      read_parameter_file(FALKO_SLAM_SOURCE_DIR "/config/nav350_simulator.yaml");
  SimulationNodeParams params;
  ParameterReader reader(tree, "~");
  visit_simulation_node_fields(params, reader);

  EXPECT_TRUE(reader.unknown().empty());
  EXPECT_EQ(values_of(params), values_of(SimulationNodeParams()));
  for (const auto& [name, value] : values_of(params)) EXPECT_TRUE(tree.hasMember(name)) << name;
}

TEST(SimulationNodeParams, AreReadByTheirNames) {
  XmlRpc::XmlRpcValue tree = with_scenario();
  tree["drive"] = "scenario";
  tree["rate"] = 4.0;
  tree["laser_frame"] = "cloud";
  tree["lazer_frame"] = "cloud";
  std::vector<std::string> unknown;
  const SimulationNodeParams params = read_simulation(tree, &unknown);

  EXPECT_EQ(params.drive, DriveSource::kScenario);
  EXPECT_EQ(params.rate, 4.0);
  EXPECT_EQ(params.frames.laser, "cloud");
  EXPECT_EQ(unknown, std::vector<std::string>{"/simulator/lazer_frame"});
}

TEST(SimulationNodeParams, AreRefusedByName) {
  test::expect_refused([&] { read_simulation(XmlRpc::XmlRpcValue()); }, {"/simulator/scenario"});
  XmlRpc::XmlRpcValue tree = with_scenario();
  tree["drive"] = "bag";
  test::expect_refused([&] { read_simulation(tree); }, {"/simulator/drive_bag"});
  tree["drive"] = "nobody";
  test::expect_refused([&] { read_simulation(tree); }, {"/simulator/drive"});
  tree = with_scenario();
  tree["rate"] = 0.0;
  test::expect_refused([&] { read_simulation(tree); }, {"/simulator/rate"});
  tree = with_scenario();
  tree["seed"] = -1;
  test::expect_refused([&] { read_simulation(tree); }, {"/simulator/seed"});
  tree = with_scenario();
  tree["odom_frame"] = "";
  test::expect_refused([&] { read_simulation(tree); }, {"/simulator/frames"});
}

}  // namespace
}  // namespace falko_slam
