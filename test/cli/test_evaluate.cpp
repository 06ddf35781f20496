// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/carmen_lines.hpp"
#include "support/command.hpp"
#include "support/seeds.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace {

using nlohmann::json;
using test::falko;

// Some scans of the office whose odometry drifts away.
std::string corrected_log() {
  auto random = test::seeded_random();
  SimulatedLaserParams laser;
  laser.beams = 180;
  laser.angle_min = -kPi / 2.0;
  laser.angle_increment = kPi / 180.0;
  std::string log;
  for (int i = 0; i < 6; ++i) {
    const Pose2 pose(-6.0 + 0.3 * i, -1.0, 0.1 * i);
    const Pose2 drifted(-6.0 + 0.35 * i, -1.1, 0.12 * i);
    log +=
        test::flaser_line(simulate_ranges(office_scene(), pose, laser, random), pose, drifted, i);
  }
  return log;
}

class EvaluateFeaturesCommand : public ::testing::Test {
 protected:
  test::CommandResult evaluate(const std::string& log, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"evaluate", "features", log};
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }

  test::TemporaryFolder folder_;
};

TEST_F(EvaluateFeaturesCommand, WritesItsFiguresWithTheirConditions) {
  const std::string path = folder_.file("figures.json");
  const auto result =
      evaluate(folder_.write("office.log", corrected_log()),
               {"--references", "2", "--map-orders", "3", "--seed", "5", "--json", path});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("6 scans, 2 reference scans")) << result.output;
  const json figures = json::parse(test::whole_file(path)).at(0);
  EXPECT_EQ(figures.at("log"), "office.log");
  EXPECT_EQ(figures.at("scans"), 6);
  EXPECT_EQ(figures.at("conditions").at("reference_scans"), 2);
  EXPECT_EQ(figures.at("conditions").at("map_orders"), 3);
  EXPECT_EQ(figures.at("conditions").at("seed"), 5);
  ASSERT_EQ(figures.at("detectors").size(), 5U);
  EXPECT_EQ(figures.at("detectors")[3].at("name"), "FLIRT curvature");
  const json& conditions = figures.at("descriptors").at(0).at("conditions");
  EXPECT_EQ(conditions.at(0).at("curves").at(2).at("descriptor"), "beta-grid");
  const json& start_angle = figures.at("detectors")[0].at("repeatability").at("start_angle");
  EXPECT_EQ(start_angle.at("mean"), 1.0);
}

TEST_F(EvaluateFeaturesCommand, RefusesLogsWithoutPoses) {
  const std::vector<float> ranges = {1.0F, 2.0F, 3.0F};
  const std::string raw = test::flaser_line(ranges, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1.0) +
                          test::flaser_line(ranges, {2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 2.0);
  for (const auto& [log, reason] : std::vector<std::pair<std::string, std::string>>{
           {folder_.write("raw.log", raw), "no corrected poses"},
           {folder_.write("cut.log", "FLASER 3 1 2 3\n"), "no laser scan"},
           {folder_.file("missing.log"), "cannot be read"}}) {
    const auto result = evaluate(log);
    EXPECT_EQ(result.exit_code, 1) << log;
    EXPECT_EQ(result.error_lines(), 1) << result.errors;
    EXPECT_TRUE(result.complains("falko: " + log + ": " + reason)) << result.errors;
  }
}

TEST_F(EvaluateFeaturesCommand, NamesAnOptionWithABadValue) {
  const std::string log = folder_.write("office.log", corrected_log());
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--references", "0"},
                                                        {"--references", "-3"},
                                                        {"--references", "two"},
                                                        {"--association-radius", "-1"},
                                                        {"--association-radius", "0"},
                                                        {"--association-radius", "nan"},
                                                        {"--association-radius", "0.1m"},
                                                        {"--viewpoint-distance", "-1"},
                                                        {"--viewpoint-distance", "inf"},
                                                        {"--map-separation", "-0.2"},
                                                        {"--map-orders", "0"},
                                                        {"--seed", "-1"}}) {
    const auto result = evaluate(log, {option, value});
    EXPECT_NE(result.exit_code, 0) << option << " " << value;
    EXPECT_TRUE(result.complains(option)) << result.errors;
    EXPECT_EQ(result.output, "") << option << " " << value;
  }
}

}  // namespace
}  // namespace falko_slam
