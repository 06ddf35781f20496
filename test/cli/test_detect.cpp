// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "falko_slam/features/feature_extractor.hpp"
#include "falko_slam/ros_bridge/scan_recording.hpp"
#include "support/command.hpp"
#include "support/office_scenario.hpp"

namespace falko_slam {
namespace {

using nlohmann::json;
using test::falko;

class DetectCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    recordings_ = std::make_unique<test::TemporaryFolder>();
    bag_ = recordings_->file("office.bag");
    const std::string scenario = recordings_->write("office.yaml", test::office_scenario(720));
    ASSERT_EQ(falko({"simulate", scenario, "--out", bag_}).exit_code, 0);
  }
  static void TearDownTestSuite() { recordings_.reset(); }

  static std::unique_ptr<test::TemporaryFolder> recordings_;
  static std::string bag_;
  test::TemporaryFolder folder_;
};
std::unique_ptr<test::TemporaryFolder> DetectCommand::recordings_;
std::string DetectCommand::bag_;

TEST_F(DetectCommand, ListsTheKeypointsOfEveryScan) {
  const auto result = falko({"detect", bag_, "--json", "-"});
  ASSERT_EQ(result.exit_code, 0);
  const json list = json::parse(result.output);
  FeatureExtractor extractor;
  std::size_t scan = 0;
  read_scans(bag_, "", [&](const RawScan& raw) {
    extractor.extract(raw);
    const json& keypoints = list.at(scan++).at("keypoints");
    ASSERT_EQ(keypoints.size(), extractor.features().size());
    for (std::size_t i = 0; i < keypoints.size(); ++i) {
      const Keypoint& keypoint = extractor.features()[i].keypoint;
      EXPECT_EQ(keypoints[i].at("x").get<double>(), keypoint.position.x());
      EXPECT_EQ(keypoints[i].at("y").get<double>(), keypoint.position.y());
      EXPECT_EQ(keypoints[i].at("orientation").get<double>(), keypoint.orientation);
      EXPECT_EQ(keypoints[i].at("index").get<std::size_t>(), keypoint.beam);
    }
  });
  EXPECT_EQ(list.size(), scan);
}

TEST_F(DetectCommand, PrintsHowManyThereAre) {
  const std::string path = folder_.file("keypoints.json");
  const auto result = falko({"detect", bag_, "--json", path});
  ASSERT_EQ(result.exit_code, 0);
  const json list = json::parse(test::whole_file(path));
  std::size_t keypoints = 0;
  for (const json& scan : list) keypoints += scan.at("keypoints").size();
  EXPECT_GT(keypoints, list.size());
  EXPECT_TRUE(result.says(std::to_string(list.size()) + " scans, 0 of them unusable"))
      << result.output;
  EXPECT_TRUE(result.says(std::to_string(keypoints) + " keypoints")) << result.output;
  EXPECT_EQ(result.errors, "");
}

TEST_F(DetectCommand, FindsTheSameAgain) {
  const auto once = falko({"detect", bag_, "--json", "-"});
  EXPECT_EQ(once.exit_code, 0);
  EXPECT_EQ(falko({"detect", bag_, "--json", "-"}).output, once.output);
}

TEST_F(DetectCommand, AnUpsideDownLaserSeesTheMirrorImage) {
  const json upright = json::parse(falko({"detect", bag_, "--json", "-"}).output);
  const json turned = json::parse(falko({"detect", bag_, "--json", "-", "--upside-down"}).output);
  const json& first = upright.at(0).at("keypoints").at(0);
  bool found = false;
  for (const json& keypoint : turned.at(0).at("keypoints")) {
    found =
        found || (std::abs(keypoint.at("x").get<double>() - first.at("x").get<double>()) < 0.05 &&
                  std::abs(keypoint.at("y").get<double>() + first.at("y").get<double>()) < 0.05);
  }
  EXPECT_TRUE(found);
}

TEST_F(DetectCommand, NamesARecordingThatCannotBeRead) {
  for (const std::string& path :
       {folder_.file("missing.bag"), folder_.file("missing.log"), folder_.path(),
        folder_.write("empty.log", ""), folder_.write("empty.bag", ""),
        folder_.write("garbage.log", std::string(3000, '\7')),
        folder_.write("garbage.bag", std::string(3000, '\7'))}) {
    const auto result = falko({"detect", path});
    EXPECT_EQ(result.exit_code, 1) << path;
    EXPECT_EQ(result.error_lines(), 1) << result.errors;
    EXPECT_TRUE(result.complains("falko: " + path + ": ")) << result.errors;
  }
}

TEST_F(DetectCommand, NamesTheTopicsOfTheBag) {
  const auto result = falko({"detect", bag_, "--topic", "front"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.error_lines(), 1);
  EXPECT_TRUE(result.complains("no LaserScan on front. LaserScan topics: /scan;")) << result.errors;
  EXPECT_EQ(falko({"detect", bag_, "--topic", "scan"}).exit_code, 0);
}

TEST_F(DetectCommand, NamesAFileItCannotWrite) {
  const std::string path = folder_.file("missing/keypoints.json");
  const auto result = falko({"detect", bag_, "--json", path});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.errors, "falko: " + path + ": cannot be written\n");
}

}  // namespace
}  // namespace falko_slam
