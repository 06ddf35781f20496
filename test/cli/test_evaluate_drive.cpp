// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "falko_slam/common/whole_file.hpp"
#include "support/carmen_lines.hpp"
#include "support/command.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::falko;

class EvaluateDriveCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string raw;
    std::string corrected;
    for (std::size_t i = 0; i < 5; ++i) {
      const Pose2 pose(0.3 * static_cast<double>(i), 0.0, 0.0);
      const std::vector<float> ranges(21, 3.0F);
      raw += test::flaser_line(ranges, pose, pose, static_cast<double>(i));
      corrected += test::vertex_line(i, pose);
      corrected += test::robotlaser_line(ranges, pose, pose, static_cast<double>(i));
    }
    raw_ = folder_.write("raw.log", raw);
    corrected_ = folder_.write("corrected.log", corrected);
  }

  test::TemporaryFolder folder_;
  std::string raw_;
  std::string corrected_;
};

TEST_F(EvaluateDriveCommand, PrintsAndWritesAllWaysToKnowThePoses) {
  const std::string path = folder_.file("figures.json");
  const auto result = falko({"evaluate", "drive", raw_, corrected_, "--json", path});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto figures = nlohmann::json::parse(read_whole_file(path));
  ASSERT_EQ(figures.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name = std::vector<std::string>{"corrected", "odometry", "registered"}[i];
    EXPECT_TRUE(result.says(name)) << result.output;
    EXPECT_EQ(figures[i]["poses"], name);
    EXPECT_EQ(figures[i]["keyframes"], 5);
    EXPECT_EQ(figures[i]["accepted"]["wrong"], 0);
  }
}

TEST_F(EvaluateDriveCommand, NamesTheLogsThatDoNotBelongTogether) {
  const auto result = falko({"evaluate", "drive", raw_, raw_});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.errors.find("0 of its scans are in " + raw_), std::string::npos)
      << result.errors;
}

}  // namespace
}  // namespace falko_slam
