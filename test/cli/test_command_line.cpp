// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/parameter_reader.hpp"
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "falko_slam/slam/slam_fields.hpp"
#include "support/command.hpp"
#include "support/field_values.hpp"

namespace falko_slam {
namespace {

using test::falko;

TEST(CommandLine, ExplainsItsVerbs) {
  const auto help = falko({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* verb : {"convert", "detect", "evaluate", "parameters", "simulate", "slam"}) {
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

TEST(CommandLine, ListsTheVerbsForOneThatThereIsNot) {
  const auto result = falko({"evaluate", "precison", "a.yaml", "--seed", "1"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_TRUE(result.complains("precison is no command of falko evaluate")) << result.errors;
  EXPECT_TRUE(result.complains("features, ")) << result.errors;
  EXPECT_TRUE(result.complains(", precision")) << result.errors;
  EXPECT_TRUE(falko({"slma"}).complains("slma is no command of falko\nfalko has: calibrate, "));
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

constexpr char kFeatures[] = FALKO_SLAM_SOURCE_DIR "/config/keypoint_detector.yaml";
constexpr char kSlam[] = FALKO_SLAM_SOURCE_DIR "/config/slam.yaml";

// As `parameters` prints them.
std::string printed(const test::TemporaryFolder& folder, const std::vector<std::string>& words) {
  const auto result = falko(words);
  EXPECT_EQ(result.exit_code, 0);
  return folder.write("printed.yaml", result.output);
}

TEST(ParametersCommand, PrintsTheShippedFile) {
  const test::TemporaryFolder folder;
  const auto values_in = [](const std::string& path) {
    ParameterReader reader(read_parameter_file(path), "~");
    FeatureExtractorParams params;
    test::FieldChanger changer;
    visit_feature_extractor_fields(params, changer);
    visit_feature_extractor_fields(params, reader);
    EXPECT_TRUE(reader.unknown({"base_frame"}).empty());
    return test::values_of(params);
  };
  const std::string file = printed(folder, {"parameters"});
  EXPECT_EQ(values_in(file), values_in(kFeatures));
  // All but base_frame, which is the nodelet's.
  EXPECT_EQ(read_parameter_file(file).size() + 1, read_parameter_file(kFeatures).size());
}

TEST(ParametersCommand, PrintsThoseOfSlam) {
  const test::TemporaryFolder folder;
  const auto values_in = [](const std::string& path) {
    ParameterReader reader(read_parameter_file(path), "~");
    SlamParams params;
    test::FieldChanger changer;
    visit_slam_fields(params, changer);
    visit_slam_fields(params, reader);
    test::FieldValues values;
    visit_slam_fields(params, values);
    return values.values();
  };
  EXPECT_EQ(values_in(printed(folder, {"parameters", "slam"})), values_in(kSlam));
}

}  // namespace
}  // namespace falko_slam
