// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "support/command.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::falko;

class EvaluateSlamCommand : public ::testing::Test {
 protected:
  // 1 m ahead each second; online a tenth too far.
  void SetUp() override {
    Trajectory truth, online;
    for (int i = 0; i < 5; ++i) {
      const Time stamp(from_seconds(i));
      truth.push_back({stamp, {1.0 * i, 0.0, 0.0}});
      online.push_back({stamp, {1.1 * i, 0.0, 0.0}});
    }
    write_tum(folder_.file("trajectory.tum"), truth);
    write_tum(folder_.file("trajectory_online.tum"), online);
    truth_ = folder_.file("truth.tum");
    write_tum(truth_, truth);
    relations_ =
        folder_.write("relations.gz", "0 2 2 0 0 0 0 0.1\n3 4 1 0 0 0 0 0.1\n8 9 1 0 0 0 0 0\n");
  }
  test::CommandResult evaluate(std::vector<std::string> words) const {
    words.insert(words.begin(), {"evaluate", "slam", folder_.path()});
    return falko(words);
  }

  test::TemporaryFolder folder_;
  std::string truth_;
  std::string relations_;
};

TEST_F(EvaluateSlamCommand, MeasuresBothTrajectories) {
  const std::string path = folder_.file("figures.json");
  const auto result = evaluate({"--relations", relations_, "--truth", truth_, "--json", path});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("2 relations compared, 1 left out")) << result.output;
  const auto figures = nlohmann::json::parse(read_whole_file(path)).at("trajectories");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0]["trajectory"], "trajectory.tum");
  EXPECT_EQ(figures[0]["poses"], 5);
  EXPECT_EQ(figures[0]["relations"]["missing"], 1);
  EXPECT_NEAR(figures[0]["relations"]["translation_m"]["mean"], 0.0, 1e-9);
  EXPECT_NEAR(figures[0]["relations"]["rotation_deg"]["mean"], 5.7296, 1e-3);
  EXPECT_NEAR(figures[0]["truth"]["absolute"]["translation_m"]["max"], 0.0, 1e-9);
  EXPECT_EQ(figures[1]["trajectory"], "trajectory_online.tum");
  EXPECT_NEAR(figures[1]["relations"]["translation_m"]["mean"], 0.15, 1e-6);
  EXPECT_NEAR(figures[1]["truth"]["absolute"]["translation_m"]["max"], 0.2, 1e-6);
  EXPECT_NEAR(figures[1]["truth"]["relative"]["translation_m"]["median"], 0.1, 1e-6);
}

TEST_F(EvaluateSlamCommand, MeasuresTheOneAskedFor) {
  const auto result =
      evaluate({"--relations", relations_, "--trajectory", "trajectory_online.tum"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("trajectory_online.tum: 5 poses")) << result.output;
  EXPECT_FALSE(result.says("trajectory.tum: 5 poses")) << result.output;
}

TEST_F(EvaluateSlamCommand, WantsGroundTruth) {
  const auto result = evaluate({});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.errors.find("give --relations, --truth or both"), std::string::npos);
}

TEST_F(EvaluateSlamCommand, NamesTheFilesThatDoNotBelongTogether) {
  folder_.write("other", "100 101 1 0 0 0 0 0\n");
  const auto result = evaluate({"--relations", folder_.file("other")});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.errors.find(folder_.file("trajectory.tum") + " against " +
                               folder_.file("other") + ": none of 1 relations"),
            std::string::npos)
      << result.errors;
}

TEST_F(EvaluateSlamCommand, NamesAFolderWithoutTrajectories) {
  const test::TemporaryFolder empty;
  const auto result = falko({"evaluate", "slam", empty.path(), "--truth", truth_});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.errors.find(empty.path() + ": holds neither trajectory.tum"), std::string::npos)
      << result.errors;
}

}  // namespace
}  // namespace falko_slam
