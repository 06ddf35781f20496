// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_node_params.hpp"

#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "support/field_values.hpp"
#include "support/refusals.hpp"

namespace falko_slam {
namespace {

constexpr char kShippedLocalizer[] = FALKO_SLAM_SOURCE_DIR "/config/localizer.yaml";

std::map<std::string, std::string> values_of(const LocalizerNodeParams& params) {
  test::FieldValues values;
  visit_localizer_node_fields(params, values);
  return values.values();
}

LocalizerNodeParams read_localizer(const XmlRpc::XmlRpcValue& tree) {
  std::vector<std::string> unknown;
  LocalizerNodeParams params = read_localizer_node_params(tree, "/localizer", unknown);
  EXPECT_TRUE(unknown.empty());
  return params;
}

XmlRpc::XmlRpcValue tree_with_map() {
  XmlRpc::XmlRpcValue tree;
  tree["map_file"] = "/maps/plant.yaml";
  return tree;
}

TEST(ShippedLocalizerYaml, HoldsTheDefaultsOfEveryField) {
  LocalizerNodeParams params;
  test::FieldChanger changer;  // whatever the file leaves out would stay changed
  visit_localizer_node_fields(params, changer);
  ParameterReader reader(read_parameter_file(kShippedLocalizer), "~");
  visit_localizer_node_fields(params, reader);

  EXPECT_TRUE(reader.unknown().empty()) << reader.unknown().front();
  EXPECT_EQ(values_of(params), values_of(LocalizerNodeParams()));
}

TEST(LocalizerNodeParameters, ComeFromTheTree) {
  XmlRpc::XmlRpcValue tree = tree_with_map();
  tree["motion_source"] = "odom";
  tree["sight_source"] = "reflectors";
  tree["map_frame"] = "/plant";
  tree["monitor"]["evidence"]["mapped"] = 0.9;
  tree["vehicle"]["laser_x"] = 1.5;

  const LocalizerNodeParams params = read_localizer(tree);

  EXPECT_EQ(params.motion_source, MotionSource::kOdometry);
  EXPECT_EQ(params.sight_source, SightSource::kReflectors);
  EXPECT_EQ(params.map_frame, "plant");
  EXPECT_EQ(params.localizer.monitor.evidence.mapped, 0.9);
  EXPECT_EQ(params.localizer.base_T_laser.x(), 1.5);
}

TEST(LocalizerNodeParameters, AreRefusedByName) {
  EXPECT_EQ(test::refusal_of([] { read_localizer(XmlRpc::XmlRpcValue()); }),
            "/localizer: map_file is empty: there must be a map of landmarks");
  XmlRpc::XmlRpcValue tree = tree_with_map();
  tree["odom_frame"] = "map";
  EXPECT_EQ(test::refusal_of([&] { read_localizer(tree); }),
            "/localizer: map_frame and odom_frame are both map");
  tree = tree_with_map();
  tree["transform_period"] = 0;
  EXPECT_EQ(test::refusal_of([&] { read_localizer(tree); }),
            "/localizer: transform_period = 0: must be in [0.001, 10]");
  tree = tree_with_map();
  tree["monitor"]["evidence"]["mapped"] = "all";
  EXPECT_EQ(test::refusal_of([&] { read_localizer(tree); }),
            "/localizer/monitor/evidence/mapped is a text, must be a number");
  tree = tree_with_map();
  tree["motion_source"] = "wheels";
  EXPECT_EQ(test::refusal_of([&] { read_localizer(tree); }),
            "/localizer/motion_source = wheels: must be encoders or odom");
}

TEST(LocalizerNodeParameters, NamesThatNobodyKnowsAreTold) {
  XmlRpc::XmlRpcValue tree = tree_with_map();
  tree["monitor"]["evidence"]["maped"] = 0.9;
  tree["colour"] = "red";
  std::vector<std::string> unknown;
  read_localizer_node_params(tree, "/localizer", unknown);
  EXPECT_EQ(unknown,
            (std::vector<std::string>{"/localizer/colour", "/localizer/monitor/evidence/maped"}));
}

}  // namespace
}  // namespace falko_slam
