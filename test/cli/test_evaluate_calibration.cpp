// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace falko_slam {
namespace {

using nlohmann::json;
using test::falko;

class EvaluateCalibrationCommand : public ::testing::Test {
 protected:
  test::CommandResult evaluate(std::vector<std::string> more) const {
    std::vector<std::string> words = {"evaluate", "calibration", "--json", path_};
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }
  json figures() const { return json::parse(test::whole_file(path_)); }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("figures.json");
};

TEST_F(EvaluateCalibrationCommand, PrintsARowForEachCondition) {
  const auto result = evaluate({"--conditions", "3,19", "--runs", "4", "--known-noise"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("\n  3    4  18-50 deg   60 deg  1.0 m/s ")) << result.output;
  EXPECT_TRUE(result.says("\n 19    6  18-34 deg  240 deg  1.2 m/s ")) << result.output;
  EXPECT_TRUE(result.says("closed form / maximum likelihood / Cramer-Rao bound"));
  EXPECT_TRUE(result.says("A deviation of 4 runs is, in 95 of 100 cases, 0.268 to 1.765"))
      << result.output;
  EXPECT_TRUE(result.says("\n8 calibrations, 0 refused\n")) << result.output;
  EXPECT_TRUE(result.says("Speeds do not enter"));
}

TEST_F(EvaluateCalibrationCommand, WritesAllFiguresBesideThoseOfTheThesis) {
  const auto result = evaluate({"--conditions", "1", "--runs", "4", "--known-noise"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json document = figures();
  EXPECT_EQ(document.at("model"), "asymmetric");
  EXPECT_EQ(document.at("simulated"), false);
  const json& condition = document.at("conditions").at(0);
  EXPECT_EQ(condition.at("number"), 1);
  EXPECT_EQ(condition.at("runs"), 4);
  ASSERT_EQ(condition.at("parameters").size(), 6U);
  for (const auto& [name, parameter] : condition.at("parameters").items()) {
    EXPECT_GT(parameter.at("deviation").get<double>(), 0.0) << name;
    EXPECT_GT(parameter.at("bound").get<double>(), 0.0) << name;
    EXPECT_GE(parameter.at("coverage").get<double>(), 0.0) << name;
    EXPECT_GT(document.at("all").at(name).at("over_bound").get<double>(), 0.0) << name;
  }
  const json& l_x = condition.at("parameters").at("laser_x");
  EXPECT_NEAR(l_x.at("table_5_1").at("mean").get<double>(), 0.39028, 1e-9);
  EXPECT_NEAR(l_x.at("table_5_2").at("deviation").get<double>(), 0.16e-3, 1e-9);
  EXPECT_NEAR(document.at("truth").at("laser_x").get<double>(), 0.389, 1e-9);
}

TEST_F(EvaluateCalibrationCommand, SaysTheSameForAnyNumberOfThreads) {
  std::vector<json> documents;
  for (const char* threads : {"1", "2"}) {
    const auto result =
        evaluate({"--conditions", "1", "--runs", "3", "--known-noise", "--threads", threads});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    documents.push_back(figures());
  }
  EXPECT_EQ(documents[0], documents[1]);
}

TEST_F(EvaluateCalibrationCommand, HasOneOffsetInTheStandardModel) {
  const auto result =
      evaluate({"--conditions", "1", "--runs", "3", "--known-noise", "--model", "standard"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json document = figures();
  const json& parameters = document.at("conditions").at(0).at("parameters");
  EXPECT_EQ(parameters.at("steer_offset_forward").at("deviation"),
            parameters.at("steer_offset_backward").at("deviation"));
  EXPECT_EQ(document.at("truth").at("steer_offset_forward"),
            document.at("truth").at("steer_offset_backward"));
}

TEST_F(EvaluateCalibrationCommand, GetsBetterWithScansAtRest) {
  std::vector<double> bounds;
  for (const char* scans : {"1", "100"}) {
    const auto result =
        evaluate({"--conditions", "6", "--runs", "2", "--known-noise", "--scans-at-rest", scans});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    bounds.push_back(
        figures().at("conditions").at(0).at("parameters").at("laser_x").at("bound").get<double>());
  }
  EXPECT_NEAR(bounds[1] / bounds[0], 0.1, 0.03);
}

TEST_F(EvaluateCalibrationCommand, DrivesInTheSimulator) {
  const auto result =
      evaluate({"--simulated", "--conditions", "1", "--runs", "2", "--scans-at-rest", "2"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("\n2 calibrations, 0 refused\n")) << result.output;
  const json document = figures();
  EXPECT_EQ(document.at("simulated"), true);
  const json& l_x = document.at("conditions").at(0).at("parameters").at("laser_x");
  EXPECT_FALSE(l_x.contains("bound"));
  EXPECT_LT(std::abs(l_x.at("bias").get<double>()), 0.005);
}

TEST_F(EvaluateCalibrationCommand, NamesAnOptionWithABadValue) {
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--conditions", "0"},
                                                        {"--conditions", "1,21"},
                                                        {"--conditions", "all"},
                                                        {"--runs", "1"},
                                                        {"--seed", "-1"},
                                                        {"--model", "ackermann"},
                                                        {"--detection-noise", "0"},
                                                        {"--detection-noise", "nan"},
                                                        {"--viewpoint-bias", "-0.1"},
                                                        {"--common-slip", "0.2"},
                                                        {"--common-steer", "x"},
                                                        {"--scans-at-rest", "0"},
                                                        {"--threads", "0"}}) {
    const auto result = evaluate({option, value});
    EXPECT_NE(result.exit_code, 0) << option << " " << value;
    EXPECT_TRUE(result.complains(option)) << result.errors;
    const std::string last = value.substr(value.find(',') + 1);
    EXPECT_TRUE(result.complains(last)) << option << " " << value << ": " << result.errors;
    EXPECT_EQ(result.output, "") << option << " " << value;
  }
}

TEST_F(EvaluateCalibrationCommand, RefusesNoiseThatTheSimulatorMakesItself) {
  for (const char* option : {"--detection-noise", "--viewpoint-bias"}) {
    const auto result = evaluate({"--simulated", option, "0.01"});
    EXPECT_NE(result.exit_code, 0) << option;
    EXPECT_TRUE(result.complains(std::string("--simulated excludes ") + option)) << result.errors;
  }
  const auto result = evaluate({"--simulated", "--scans-at-rest", "1"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("scans_at_rest = 1: must be in [2, 200]")) << result.errors;
}

}  // namespace
}  // namespace falko_slam
