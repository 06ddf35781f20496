// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "support/carmen_lines.hpp"
#include "support/command.hpp"
#include "support/seeds.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace {

using nlohmann::json;
using test::falko;

constexpr std::size_t kScans = 8;

// A few scans of the office, each with its vertex. robotlaser_line() has beams of 0.1 rad from -1.
std::string posed_log() {
  auto random = test::seeded_random();
  SimulatedLaserParams laser;
  laser.beams = 21;
  laser.angle_min = -1.0;
  laser.angle_increment = 0.1;
  std::string log;
  for (std::size_t i = 0; i < kScans; ++i) {
    const Pose2 pose(-6.0 + 0.3 * static_cast<double>(i), -1.0, 0.0);
    log += test::vertex_line(i, pose);
    log += test::robotlaser_line(simulate_ranges(office_scene(), pose, laser, random), pose, pose,
                                 static_cast<double>(i));
  }
  return log;
}

class EvaluateLoopsCommand : public ::testing::Test {
 protected:
  test::CommandResult evaluate(const std::string& log, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"evaluate", "loops", log};
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }

  test::TemporaryFolder folder_;
};

TEST_F(EvaluateLoopsCommand, PrintsAllProtocols) {
  const auto result = evaluate(folder_.write("office.log", posed_log()));
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  for (const std::string protocol : {"offline", "online", "revisits"}) {
    EXPECT_TRUE(result.says("\n" + protocol + ": " + std::to_string(kScans) + " scans"))
        << result.output;
  }
}

TEST_F(EvaluateLoopsCommand, WritesAllMethodsUnderAllProtocols) {
  const std::string path = folder_.file("figures.json");
  const auto result = evaluate(folder_.write("office.log", posed_log()), {"--json", path});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json document = json::parse(test::whole_file(path));
  ASSERT_EQ(document.size(), 1U);
  EXPECT_EQ(document.at(0).at("log"), "office.log");
  std::set<std::string> found;
  for (const json& entry : document.at(0).at("methods")) {
    found.insert(entry.at("method").get<std::string>() + " " +
                 entry.at("protocol").get<std::string>());
    EXPECT_EQ(entry.at("scans"), kScans);
    for (const char* measure : {"break_even", "recall_at_100", "recall_at_95", "f1"}) {
      EXPECT_GE(entry.at(measure).get<double>(), 0.0) << measure;
      EXPECT_LE(entry.at(measure).get<double>(), 1.0) << measure;
    }
  }
  std::set<std::string> expected;
  for (const std::string method :
       {"GFP", "GSR-FLIRT", "GSR-FALKO", "GLAROT-CG", "GLAROT-AH", "GLAROT-RANSAC", "falko_slam"}) {
    for (const std::string protocol : {"offline", "online", "revisits"}) {
      expected.insert(method + " " + protocol);
    }
  }
  EXPECT_EQ(found, expected);
}

TEST_F(EvaluateLoopsCommand, WritesTimesOfThePartsThatAMethodHas) {
  const std::string path = folder_.file("figures.json");
  const auto result = evaluate(folder_.write("office.log", posed_log()),
                               {"--json", path, "--methods", "GLAROT-CG,falko_slam"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json document = json::parse(test::whole_file(path));
  for (const json& entry : document.at(0).at("methods")) {
    for (const char* part : {"detection", "search", "association"}) {
      EXPECT_EQ(entry.contains(part), entry.at("method") == "GLAROT-CG") << entry << part;
    }
    for (const char* whole : {"creation", "closing"}) {
      EXPECT_GT(entry.at(whole).at("mean_ms").get<double>(), 0.0) << entry << whole;
    }
  }
}

TEST_F(EvaluateLoopsCommand, RunsTheMethodsAskedFor) {
  const std::string path = folder_.file("figures.json");
  const std::string log = folder_.write("office.log", posed_log());
  const auto ours = evaluate(log, {"--json", path, "--methods", "falko_slam"});
  ASSERT_EQ(ours.exit_code, 0) << ours.errors;
  json figures = json::parse(test::whole_file(path)).at(0);
  ASSERT_EQ(figures.at("methods").size(), 3U);
  EXPECT_EQ(figures.at("methods").at(0).at("method"), "falko_slam");
  EXPECT_EQ(figures.at("kidnapped").at("scans"), kScans);
  EXPECT_TRUE(ours.says("\nkidnapped: " + std::to_string(kScans) + " scans")) << ours.output;

  const auto other = evaluate(log, {"--json", path, "--methods", "GLAROT-RANSAC"});
  ASSERT_EQ(other.exit_code, 0) << other.errors;
  figures = json::parse(test::whole_file(path)).at(0);
  EXPECT_EQ(figures.at("methods").size(), 3U);
  EXPECT_FALSE(figures.contains("kidnapped"));
}

TEST_F(EvaluateLoopsCommand, TakesNormalsFromAGridIfAsked) {
  const std::string log = folder_.write("office.log", posed_log());
  const auto result = evaluate(log, {"--methods", "GSR-FALKO", "--grid-normals"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("GSR-FALKO")) << result.output;
}

TEST_F(EvaluateLoopsCommand, NamesTheMethodsThereAre) {
  const std::string log = folder_.write("office.log", posed_log());
  const auto result = evaluate(log, {"--methods", "falko_slam,SIFT"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_TRUE(result.complains("--methods")) << result.errors;
  EXPECT_TRUE(result.complains("\"SIFT\" is not one of")) << result.errors;
  EXPECT_TRUE(result.complains("GLAROT-CG, falko_slam")) << result.errors;
  EXPECT_EQ(result.output, "");
}

TEST_F(EvaluateLoopsCommand, RefusesLogsWithoutPoses) {
  const std::vector<float> ranges = {1.0F, 2.0F, 3.0F};
  const std::string raw = test::flaser_line(ranges, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1.0) +
                          test::flaser_line(ranges, {2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 2.0);
  for (const auto& [log, reason] : std::vector<std::pair<std::string, std::string>>{
           {folder_.write("raw.log", raw), "no corrected poses"},
           {folder_.file("missing.log"), "cannot be read"}}) {
    const auto result = evaluate(log);
    EXPECT_EQ(result.exit_code, 1) << log;
    EXPECT_EQ(result.error_lines(), 1) << result.errors;
    EXPECT_TRUE(result.complains("falko: " + log + ": " + reason)) << result.errors;
  }
}

TEST_F(EvaluateLoopsCommand, NamesAnOptionWithABadValue) {
  const std::string log = folder_.write("office.log", posed_log());
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
           {"--candidates", "0"}, {"--candidates", "ten"}, {"--seed", "-1"}, {"--methods", ""}}) {
    const auto result = evaluate(log, {option, value});
    EXPECT_NE(result.exit_code, 0) << option << " " << value;
    EXPECT_TRUE(result.complains(option)) << result.errors;
    EXPECT_EQ(result.output, "") << option << " " << value;
  }
}

}  // namespace
}  // namespace falko_slam
