// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>

#include "support/bag_contents.hpp"
#include "support/command.hpp"

namespace falko_slam {
namespace {

using test::falko;

class SimulateCommand : public ::testing::Test {
 protected:
  test::CommandResult simulate(const std::string& name, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"simulate", "--out", folder_.file(name)};
    if (std::find(more.begin(), more.end(), "--beams") == more.end()) {
      more.insert(more.end(), {"--beams", "36"});
    }
    words.insert(words.end(), more.begin(), more.end());
    return falko(words);
  }

  test::TemporaryFolder folder_;
};

TEST_F(SimulateCommand, RepeatsWithItsSeed) {
  EXPECT_EQ(simulate("a.bag", {"--seed", "7"}).exit_code, 0);
  EXPECT_EQ(simulate("b.bag", {"--seed", "7"}).exit_code, 0);
  EXPECT_EQ(simulate("c.bag", {"--seed", "8"}).exit_code, 0);
  const auto messages = test::bag_messages(folder_.file("a.bag"));
  EXPECT_FALSE(messages.empty());
  EXPECT_TRUE(test::bag_messages(folder_.file("b.bag")) == messages);
  EXPECT_FALSE(test::bag_messages(folder_.file("c.bag")) == messages);
}

TEST_F(SimulateCommand, WritesScansWithTheirPoses) {
  const auto result = simulate("a.bag");
  const auto scans = test::bag_messages_on<sensor_msgs::LaserScan>(folder_.file("a.bag"), "/scan");
  const auto odometry = test::bag_messages_on<nav_msgs::Odometry>(folder_.file("a.bag"), "/odom");
  EXPECT_GT(scans.size(), 100U);
  EXPECT_TRUE(result.says(std::to_string(scans.size()) + " scans of 36 beams")) << result.output;
  ASSERT_EQ(odometry.size(), scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(scans[i].ranges.size(), 36U);
    EXPECT_EQ(scans[i].header.stamp, odometry[i].header.stamp);
  }
}

TEST_F(SimulateCommand, TheTransformsOfAScanPlayBeforeIt) {
  simulate("a.bag");
  const auto topics = test::topics_in_order(test::bag_messages(folder_.file("a.bag")));
  EXPECT_EQ(topics.at(0), "/tf_static");
  ASSERT_EQ(topics.size() % 3, 1U);
  for (std::size_t i = 1; i < topics.size(); i += 3) {
    EXPECT_EQ(topics[i], "/tf");
    EXPECT_EQ(topics[i + 1], "/odom");
    EXPECT_EQ(topics[i + 2], "/scan");
  }
}

TEST_F(SimulateCommand, ReplacesABagOnlyIfTold) {
  simulate("a.bag", {"--seed", "1"});
  const auto before = test::bag_messages(folder_.file("a.bag"));
  const auto refused = simulate("a.bag", {"--seed", "2"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.errors, "falko: " + folder_.file("a.bag") + ": exists already\n");
  EXPECT_TRUE(test::bag_messages(folder_.file("a.bag")) == before);
  EXPECT_EQ(simulate("a.bag", {"--seed", "2", "--force"}).exit_code, 0);
  EXPECT_FALSE(test::bag_messages(folder_.file("a.bag")) == before);
}

TEST_F(SimulateCommand, NamesABagThatCannotBeWritten) {
  const auto result = simulate("missing/a.bag");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.error_lines(), 1);
  EXPECT_TRUE(result.complains(folder_.file("missing/a.bag"))) << result.errors;
}

TEST_F(SimulateCommand, NamesAnOptionWithABadValue) {
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--beams", "3"},
                                                        {"--beams", "many"},
                                                        {"--noise", "-0.1"},
                                                        {"--noise", "nan"},
                                                        {"--seed", "-1"}}) {
    const auto result = simulate("a.bag", {option, value});
    EXPECT_NE(result.exit_code, 0) << option << " " << value;
    EXPECT_TRUE(result.complains(option)) << result.errors;
  }
  EXPECT_TRUE(folder_.names().empty());
}

}  // namespace
}  // namespace falko_slam
