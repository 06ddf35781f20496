// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/ros_bridge/scan_recording.hpp"
#include "support/command.hpp"
#include "support/office_scenario.hpp"

namespace falko_slam {
namespace {

using nlohmann::json;
using test::falko;

const std::set<std::string> kFiles = {
    "trajectory.tum", "trajectory_online.tum", "map.yaml",   "map.pgm", "map.png",
    "graph.g2o",      "closures.csv",          "report.json"};

class SlamCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    recordings_ = std::make_unique<test::TemporaryFolder>();
    bag_ = recordings_->file("office.bag");
    const std::string scenario = recordings_->write("office.yaml", test::office_scenario(360));
    ASSERT_EQ(falko({"simulate", scenario, "--out", bag_}).exit_code, 0);
  }
  static void TearDownTestSuite() { recordings_.reset(); }

  test::CommandResult slam(const std::string& name, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"slam", bag_, "--out", folder_.file(name)};
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }
  std::string content(const std::string& name, const std::string& file) const {
    return test::whole_file(folder_.file(name + "/" + file));
  }
  json report(const std::string& name) const { return json::parse(content(name, "report.json")); }
  Trajectory trajectory(const std::string& name) const {
    return read_tum(folder_.file(name + "/trajectory.tum"));
  }

  static std::unique_ptr<test::TemporaryFolder> recordings_;
  static std::string bag_;
  test::TemporaryFolder folder_;
};
std::unique_ptr<test::TemporaryFolder> SlamCommand::recordings_;
std::string SlamCommand::bag_;

TEST_F(SlamCommand, WritesAllItsFilesToAFolderThatItMakes) {
  const auto result = slam("new/folder");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.file("new/folder"))) {
    names.insert(entry.path().filename().string());
    EXPECT_GT(entry.file_size(), 0U) << entry.path();
  }
  EXPECT_EQ(names, kFiles);
}

TEST_F(SlamCommand, ReplacesAnEarlierRunOnlyIfToldTo) {
  const std::string old = folder_.write("report.json", "old");
  const auto refused = slam("");
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_TRUE(refused.complains("report.json: exists already; --force replaces it"))
      << refused.errors;
  EXPECT_EQ(test::whole_file(old), "old");
  EXPECT_EQ(slam("", {"--force"}).exit_code, 0);
  EXPECT_EQ(report("").at("lost_scans"), 0);
}

TEST_F(SlamCommand, WritesAPoseForEachScanInTheirOrder) {
  ASSERT_EQ(slam("out").exit_code, 0);
  std::vector<Time> stamps;
  read_scans(bag_, "", [&](const RawScan& raw) { stamps.push_back(raw.stamp); });
  for (const char* name : {"trajectory.tum", "trajectory_online.tum"}) {
    const Trajectory poses = read_tum(folder_.file(std::string("out/") + name));
    ASSERT_EQ(poses.size(), stamps.size()) << name;
    for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_EQ(poses[i].stamp, stamps[i]) << i;
  }
}

TEST_F(SlamCommand, ReportsWhatItDid) {
  const auto result = slam("out");
  const json figures = report("out");
  EXPECT_EQ(figures.at("recording"), bag_);
  EXPECT_EQ(figures.at("scans").get<std::size_t>(), trajectory("out").size());
  EXPECT_EQ(figures.at("scans_without_odometry"), 0);
  EXPECT_EQ(figures.at("lost_scans"), 0);
  EXPECT_GT(figures.at("keyframes").get<int>(), 50);
  EXPECT_TRUE(figures.at("stage_seconds").contains("tracking"));
  EXPECT_GT(figures.at("peak_memory_mb").get<double>(), 1.0);
  EXPECT_TRUE(result.says(std::to_string(figures.at("keyframes").get<int>()) + " keyframes"))
      << result.output;
}

TEST_F(SlamCommand, WritesTheSameBytesForTheSameRecording) {
  ASSERT_EQ(slam("a").exit_code, 0);
  ASSERT_EQ(slam("b").exit_code, 0);
  for (const std::string& name : kFiles) {
    if (name == "report.json") continue;  // tells the times
    EXPECT_EQ(content("a", name), content("b", name)) << name;
  }
}

TEST_F(SlamCommand, SaysThatThereIsNoOdometry) {
  const auto result = slam("out", {"--no-odometry"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::string scans = std::to_string(trajectory("out").size());
  EXPECT_TRUE(result.complains(scans + " of " + scans + " scans without odometry"))
      << result.errors;
  EXPECT_EQ(report("out").at("scans_without_odometry").get<std::size_t>(),
            trajectory("out").size());
  EXPECT_EQ(report("out").at("searched_scans"), 0);
  const auto other = slam("other", {"--odom-frame", "nowhere"});
  EXPECT_TRUE(other.complains("scans without odometry (nowhere)")) << other.errors;
}

TEST_F(SlamCommand, FalseClosuresLeaveTheTrajectoryAsItIs) {
  ASSERT_EQ(slam("clean").exit_code, 0);
  ASSERT_EQ(slam("injected", {"--inject-outliers", "1"}).exit_code, 0);
  const json closures = report("injected").at("closures");
  EXPECT_FALSE(closures.at("refused").value("proposed", json::object()).empty()) << closures;
  EXPECT_FALSE(closures.at("accepted").contains("proposed")) << closures;
  const Trajectory clean = trajectory("clean"), injected = trajectory("injected");
  for (std::size_t i = 0; i < clean.size(); ++i) {
    EXPECT_LT((clean[i].map_T_base.translation() - injected[i].map_T_base.translation()).norm(),
              0.01)
        << i;
  }
}

TEST_F(SlamCommand, NamesWhatItCannotReadOrWrite) {
  for (const std::string& path :
       {folder_.file("missing.bag"), folder_.file("missing.log"), folder_.write("empty.log", "")}) {
    const auto result = falko({"slam", path, "--out", folder_.file("out")});
    EXPECT_EQ(result.exit_code, 1) << path;
    EXPECT_EQ(result.error_lines(), 1) << result.errors;
    EXPECT_TRUE(result.complains("falko: " + path + ": ")) << result.errors;
  }
  const std::string taken = folder_.write("taken", "a file");
  const auto result = falko({"slam", bag_, "--out", taken + "/out"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.error_lines(), 1) << result.errors;
  EXPECT_TRUE(result.complains("falko: " + taken + "/out: cannot be made")) << result.errors;
  const auto file = falko({"slam", bag_, "--out", taken});
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_TRUE(file.complains("falko: " + taken)) << file.errors;
}

TEST_F(SlamCommand, NamesTheTopicsOfTheBag) {
  const auto result = slam("out", {"--topic", "front"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_TRUE(result.complains("no LaserScan on front. LaserScan topics: /scan;")) << result.errors;
}

}  // namespace
}  // namespace falko_slam
