// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// config/keypoint_detector.yaml and config/KeypointDetector.cfg against the structs they are of.
#include <falko_slam/KeypointDetectorConfig.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <set>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/reconfigure.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "support/field_values.hpp"

namespace falko_slam {
namespace {

using Values = std::map<std::string, std::string>;

constexpr char kShippedDetector[] = FALKO_SLAM_SOURCE_DIR "/config/keypoint_detector.yaml";

YAML::Node shipped_detector() { return YAML::LoadFile(kShippedDetector); }

std::set<std::string> names_of(const Values& values) {
  std::set<std::string> names;
  for (const auto& [name, value] : values) names.insert(name);
  return names;
}

dynamic_reconfigure::Config shipped_reconfiguration() {
  dynamic_reconfigure::Config message;
  KeypointDetectorConfig::__getDefault__().__toMessage__(message);
  return message;
}

TEST(ShippedYaml, HasNoNameThatNobodyReads) {
  ParameterReader reader(read_parameter_file(kShippedDetector), "~");
  FeatureExtractorParams params;
  visit_feature_extractor_fields(params, reader);
  EXPECT_EQ(reader.unknown(), (std::vector<std::string>{"~/base_frame"}));
  std::string base_frame = "unread";
  reader.field("base_frame", base_frame);
  EXPECT_EQ(base_frame, "");
}

TEST(ShippedYaml, HasEveryField) {
  std::set<std::string> names;
  for (const auto& group : shipped_detector()) {
    if (!group.second.IsMap()) continue;
    for (const auto& field : group.second) {
      names.insert(group.first.as<std::string>() + "/" + field.first.as<std::string>());
    }
  }
  EXPECT_EQ(names, names_of(test::values_of(FeatureExtractorParams())));
}

TEST(ShippedYaml, HoldsTheDefaults) {
  ParameterReader reader(read_parameter_file(kShippedDetector), "~");
  FeatureExtractorParams params;
  test::FieldChanger changer;
  visit_feature_extractor_fields(params, changer);
  visit_feature_extractor_fields(params, reader);
  EXPECT_EQ(test::values_of(params), test::values_of(FeatureExtractorParams()));
}

TEST(ShippedReconfiguration, HasTheNamesOfFalko) {
  const auto config = shipped_reconfiguration();
  std::set<std::string> names;
  for (const auto& entry : config.doubles) names.insert(entry.name);
  for (const auto& entry : config.ints) names.insert(entry.name);
  for (const auto& entry : config.strs) names.insert(entry.name);
  for (const auto& entry : config.bools) names.insert(entry.name);
  EXPECT_EQ(names, names_of(test::values_of(FalkoParams())));
}

TEST(ShippedReconfiguration, HoldsTheDefaults) {
  const auto config = shipped_reconfiguration();
  ReconfigureReader reader(config);
  FalkoParams params;
  test::FieldChanger changer;
  visit_falko_fields(params, changer);
  visit_falko_fields(params, reader);
  EXPECT_EQ(test::values_of(params), test::values_of(FalkoParams()));
}

TEST(ShippedReconfiguration, TakesWhatTheStructsHold) {
  const FalkoParams thesis = thesis_falko_params();
  ReconfigureWriter writer;
  visit_falko_fields(thesis, writer);
  auto message = writer.config();
  KeypointDetectorConfig config = KeypointDetectorConfig::__getDefault__();
  EXPECT_TRUE(config.__fromMessage__(message));
  config.__toMessage__(message);
  FalkoParams params;
  ReconfigureReader reader(message);
  visit_falko_fields(params, reader);
  EXPECT_EQ(test::values_of(params), test::values_of(thesis));
}

}  // namespace
}  // namespace falko_slam
