// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// config/loop_closure.yaml against the structs it is of.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <set>

#include "falko_slam/place_recognition/loop_closure_fields.hpp"
#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "support/field_values.hpp"

namespace falko_slam {
namespace {

constexpr char kShippedLoops[] = FALKO_SLAM_SOURCE_DIR "/config/loop_closure.yaml";

YAML::Node shipped_loops() { return YAML::LoadFile(kShippedLoops); }

std::map<std::string, std::string> values_of(const LoopClosureParams& params) {
  test::FieldValues values;
  visit_loop_closure_fields(params, values);
  return values.values();
}

TEST(ShippedLoopClosureYaml, HasNoNameThatNobodyReads) {
  ParameterReader reader(read_parameter_file(kShippedLoops), "~");
  LoopClosureParams params;
  visit_loop_closure_fields(params, reader);
  EXPECT_EQ(reader.unknown({"odom_frame", "base_frame", "folder", "database"}),
            std::vector<std::string>());
}

TEST(ShippedLoopClosureYaml, HasEveryField) {
  std::set<std::string> names;
  for (const auto& group : shipped_loops()) {
    if (!group.second.IsMap()) continue;
    for (const auto& field : group.second) {
      names.insert(group.first.as<std::string>() + "/" + field.first.as<std::string>());
    }
  }
  std::set<std::string> expected;
  for (const auto& [name, value] : values_of(LoopClosureParams())) expected.insert(name);
  EXPECT_EQ(names, expected);
}

TEST(ShippedLoopClosureYaml, HoldsTheDefaults) {
  ParameterReader reader(read_parameter_file(kShippedLoops), "~");
  LoopClosureParams params;
  test::FieldChanger changer;
  visit_loop_closure_fields(params, changer);
  EXPECT_NE(values_of(params), values_of(LoopClosureParams()));
  visit_loop_closure_fields(params, reader);
  EXPECT_EQ(values_of(params), values_of(LoopClosureParams()));
}

TEST(LoopClosureFields, AreTheDetectorsAndNotCopies) {
  XmlRpc::XmlRpcValue tree;
  tree["loops"]["min_score"] = 0.7;
  tree["falko"]["sectors"] = 12;
  tree["signature"]["wall_range"] = 9;
  tree["view"]["max_range"] = 20.0;
  LoopClosureParams params;
  ParameterReader reader(tree, "~");
  visit_loop_closure_fields(params, reader);
  EXPECT_EQ(params.detector.min_score, 0.7);
  EXPECT_EQ(params.detector.keyframe.falko.sectors, 12);
  EXPECT_EQ(params.detector.keyframe.wall_range, 9.0);
  EXPECT_EQ(params.detector.keyframe.view.max_range, 20.0);
}

}  // namespace
}  // namespace falko_slam
