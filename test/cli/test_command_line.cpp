// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "support/command.hpp"
#include "support/field_values.hpp"
#include "support/yaml_parameters.hpp"

namespace falko_slam {
namespace {

using test::falko;

TEST(CommandLine, ExplainsItsVerbs) {
  const auto help = falko({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* verb : {"convert", "detect", "evaluate", "parameters", "simulate"}) {
    EXPECT_TRUE(help.says(verb)) << verb;
    EXPECT_EQ(falko({verb, "--help"}).exit_code, 0) << verb;
  }
  EXPECT_EQ(falko({"evaluate", "features", "--help"}).exit_code, 0);
}

TEST(CommandLine, NamesAVerbThatThereIsNot) {
  const auto result = falko({"frobnicate"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_TRUE(result.complains("frobnicate")) << result.errors;
  EXPECT_TRUE(result.complains("--help")) << result.errors;
  EXPECT_EQ(result.output, "");
}

TEST(CommandLine, NeedsAVerb) {
  for (const auto& words : {std::vector<std::string>{}, std::vector<std::string>{"evaluate"}}) {
    const auto result = falko(words);
    EXPECT_NE(result.exit_code, 0);
    EXPECT_TRUE(result.complains("--help")) << result.errors;
  }
}

TEST(CommandLine, NamesAnOptionThatThereIsNot) {
  const auto result = falko({"parameters", "--frobnicate"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_TRUE(result.complains("--frobnicate")) << result.errors;
}

std::map<std::string, std::string> values_in(const YAML::Node& yaml) {
  ParameterReader reader(test::parameters_from(yaml), "~");
  FeatureExtractorParams params;
  test::FieldChanger changer;
  visit_feature_extractor_fields(params, changer);
  visit_feature_extractor_fields(params, reader);
  EXPECT_TRUE(reader.unknown({"base_frame"}).empty());
  return test::values_of(params);
}

TEST(ParametersCommand, PrintsTheShippedFile) {
  const auto result = falko({"parameters"});
  EXPECT_EQ(result.exit_code, 0);
  const YAML::Node printed = YAML::Load(result.output);
  const YAML::Node shipped = YAML::LoadFile(FALKO_SLAM_SOURCE_DIR "/config/keypoint_detector.yaml");
  EXPECT_EQ(values_in(printed), values_in(shipped));
  EXPECT_EQ(printed.size() + 1, shipped.size());  // all but base_frame, which is the nodelet's
}

}  // namespace
}  // namespace falko_slam
