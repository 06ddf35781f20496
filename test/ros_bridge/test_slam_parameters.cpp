// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// config/slam.yaml against the structs it is of, and how it is read.
#include <gtest/gtest.h>

#include <set>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/slam_node_params.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "falko_slam/slam/slam_fields.hpp"
#include "support/field_values.hpp"

namespace falko_slam {
namespace {

constexpr char kShippedSlam[] = FALKO_SLAM_SOURCE_DIR "/config/slam.yaml";

std::map<std::string, std::string> values_of(const SlamNodeParams& params) {
  test::FieldValues values;
  visit_slam_node_fields(params, values);
  visit_slam_fields(params.slam, values);
  return values.values();
}

class NodeChanger : public test::FieldChanger {
 public:
  using FieldChanger::field;
  void field(const char*, std::string& value) const { value += "?"; }
};

std::string complaint_of(const XmlRpc::XmlRpcValue& tree) {
  std::vector<std::string> unknown;
  try {
    read_slam_node_params(tree, "/slam", unknown);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ShippedSlamYaml, HoldsTheDefaultsOfEveryField) {
  ParameterReader reader(read_parameter_file(kShippedSlam), "~");
  SlamNodeParams params;
  NodeChanger changer;
  visit_slam_node_fields(params, changer);
  visit_slam_fields(params.slam, changer);
  EXPECT_NE(values_of(params), values_of(SlamNodeParams()));
  visit_slam_node_fields(params, reader);
  visit_slam_fields(params.slam, reader);
  EXPECT_EQ(values_of(params), values_of(SlamNodeParams()));
  EXPECT_EQ(reader.unknown(), std::vector<std::string>());
}

TEST(SlamNodeParams, HaveCleanFramesAndWholePaths) {
  XmlRpc::XmlRpcValue tree;
  tree["odom_frame"] = "/odometry";
  tree["map_folder"] = "/maps";
  tree["state"] = "hall.slam";
  tree["misspelt"] = 1;
  std::vector<std::string> unknown;
  const SlamNodeParams params = read_slam_node_params(tree, "/slam", unknown);
  EXPECT_EQ(params.odom_frame, "odometry");
  EXPECT_EQ(params.state, "/maps/hall.slam");
  EXPECT_EQ(unknown, std::vector<std::string>{"/slam/misspelt"});
  tree["odom_frame"] = "";
  EXPECT_FALSE(read_slam_node_params(tree, "/slam", unknown).use_odometry);
}

TEST(SlamNodeParams, AreRefusedWithTheirNameAndValue) {
  XmlRpc::XmlRpcValue tree;
  tree["transform_period"] = 0.0;
  EXPECT_EQ(complaint_of(tree), "/slam: transform_period = 0: must be in [0.001, 10]");
  tree["transform_period"] = 0.05;
  tree["map"]["resolution"] = 3.0;
  EXPECT_NE(complaint_of(tree).find("resolution = 3"), std::string::npos) << complaint_of(tree);
  tree["map"]["resolution"] = "fine";
  EXPECT_EQ(complaint_of(tree), "/slam/map/resolution is a text, must be a number");
  tree["map"]["resolution"] = 0.1;
  tree["map_frame"] = "odom";
  EXPECT_EQ(complaint_of(tree), "/slam: map_frame and odom_frame are both odom");
  tree["map_frame"] = "";
  EXPECT_EQ(complaint_of(tree), "/slam: map_frame is empty");
  tree["map_frame"] = "map";
  tree["use_odometry"] = false;
  tree["base_frame"] = "";
  EXPECT_EQ(complaint_of(tree),
            "/slam: base_frame is empty, and without odometry it is what tf to the map is of");
}

TEST(SlamFields, AreThoseOfTheCoreAndNotCopies) {
  XmlRpc::XmlRpcValue tree;
  tree["tracker"]["min_step"] = 1.5;
  tree["optimizer"]["closure_loss"] = "huber";
  tree["loops"]["min_score"] = 0.7;
  tree["falko"]["sectors"] = 12;
  tree["odom_frame"] = "of the node";
  std::vector<std::string> unknown;
  const SlamParams params = read_slam_params(tree, "a.yaml", unknown);
  EXPECT_EQ(params.tracker.min_step, 1.5);
  EXPECT_EQ(params.optimizer.closure_loss, Loss::kHuber);
  EXPECT_EQ(params.loops.min_score, 0.7);
  EXPECT_EQ(params.loops.keyframe.falko.sectors, 12);
  EXPECT_TRUE(unknown.empty());
}

}  // namespace
}  // namespace falko_slam
