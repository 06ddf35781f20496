// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/mode_switch_params.hpp"

#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "support/field_values.hpp"

namespace falko_slam {
namespace {

std::map<std::string, std::string> values_of(const ModeSwitchParams& params) {
  test::FieldValues values;
  visit_mode_switch_fields(params, values);
  return values.values();
}

TEST(ShippedModeSwitchYaml, HoldsTheDefaultsOfEveryField) {
  const XmlRpc::XmlRpcValue tree =
      read_parameter_file(FALKO_SLAM_SOURCE_DIR "/config/mode_switch.yaml");
  ModeSwitchParams params;
  test::FieldChanger changer;  // whatever the file leaves out would stay changed
  visit_mode_switch_fields(params, changer);
  ParameterReader reader(tree, "~");
  visit_mode_switch_fields(params, reader);

  EXPECT_TRUE(reader.unknown().empty());
  EXPECT_EQ(values_of(params), values_of(ModeSwitchParams()));
}

TEST(ModeSwitchParams, TellWhichValueIsBad) {
  for (const char* field : {"manager", "mapping_node", "localization_node", "save_as", "mode"}) {
    XmlRpc::XmlRpcValue tree;
    tree[field] = "";
    std::vector<std::string> unknown;
    EXPECT_THROW(read_mode_switch_params(tree, "/agv", unknown), std::invalid_argument) << field;
  }
  XmlRpc::XmlRpcValue tree;
  tree["save_as"] = "../outside";
  std::vector<std::string> unknown;
  EXPECT_THROW(read_mode_switch_params(tree, "/agv", unknown), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
