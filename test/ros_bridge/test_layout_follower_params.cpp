// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/layout_follower_params.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "support/field_values.hpp"
#include "support/refusals.hpp"

namespace falko_slam {
namespace {

constexpr char kLayout[] = FALKO_SLAM_SOURCE_DIR "/config/layouts/warehouse.yaml";

std::map<std::string, std::string> values_of(const LayoutFollowerNodeParams& params) {
  test::FieldValues values;
  visit_layout_follower_fields(params, values);
  return values.values();
}

LayoutFollowerNodeParams read_follower(const XmlRpc::XmlRpcValue& tree) {
  std::vector<std::string> unknown;
  return read_layout_follower_params(tree, "/layout_follower", unknown);
}

TEST(ShippedLayoutFollowerYaml, HoldsTheDefaultsOfEveryField) {
  const XmlRpc::XmlRpcValue tree =
      read_parameter_file(FALKO_SLAM_SOURCE_DIR "/config/layout_follower.yaml");
  LayoutFollowerNodeParams params;
  test::FieldChanger changer;
  visit_layout_follower_fields(params, changer);
  ParameterReader reader(tree, "~");
  visit_layout_follower_fields(params, reader);
  EXPECT_TRUE(reader.unknown().empty());
  EXPECT_EQ(values_of(params), values_of(LayoutFollowerNodeParams()));
}

TEST(LayoutFollowerNodeParams, HoldTheLayoutAndTheVehicle) {
  XmlRpc::XmlRpcValue tree;
  tree["layout_file"] = std::string(kLayout);
  tree["vehicle"]["wheelbase"] = 1.2;
  tree["misspelt"] = 1;
  std::vector<std::string> unknown;
  const LayoutFollowerNodeParams params =
      read_layout_follower_params(tree, "/layout_follower", unknown);
  EXPECT_EQ(params.layout.name, "warehouse");
  EXPECT_EQ(params.follower.tricycle.wheelbase, 1.2);
  ASSERT_EQ(unknown.size(), 1U);
  EXPECT_NE(unknown[0].find("misspelt"), std::string::npos);
}

TEST(LayoutFollowerNodeParams, AreRefusedByName) {
  XmlRpc::XmlRpcValue tree;
  tree["layout_file"] = std::string("/nowhere/layout.yaml");
  test::expect_refused([&] { read_follower(tree); }, {"/nowhere/layout.yaml"});
  tree["layout_file"] = std::string(kLayout);
  tree["pose_timeout"] = -1.0;
  test::expect_refused([&] { read_follower(tree); }, {"pose_timeout"});
}

}  // namespace
}  // namespace falko_slam
