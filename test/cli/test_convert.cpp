// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/bag_contents.hpp"
#include "support/carmen_lines.hpp"
#include "support/command.hpp"

namespace falko_slam {
namespace {

using test::falko;

std::string small_log() {
  return test::flaser_line({1.0F, 2.0F, 3.0F}, {}, {}, 1.0) + test::odom_line({}, 2.0) +
         test::flaser_line({1.0F, 2.0F, 3.5F}, {}, {}, 3.0);
}

class ConvertCommand : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::string bag_ = folder_.file("test.bag");
};

TEST_F(ConvertCommand, ReadsPlainAndPackedLogsAlike) {
  const std::vector<std::string> topics = {"/tf_static", "/tf",   "/odom",
                                           "/scan",      "/tf",   "/odom",  //
                                           "/tf",        "/odom", "/scan"};
  for (const char* name : {"test.log", "test.log.gz", "test.log.bz2"}) {
    const auto result = falko({"convert", folder_.write(name, small_log()), bag_, "--force"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_TRUE(result.says("3 lines: 2 scans, 1 odometry readings")) << result.output;
    EXPECT_EQ(test::topics_in_order(test::bag_messages(bag_)), topics) << name;
  }
}

TEST_F(ConvertCommand, WhatItWritesCanBeDetectedIn) {
  falko({"convert", folder_.write("test.log", small_log()), bag_});
  const auto result = falko({"detect", bag_});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(result.says("2 scans on /scan")) << result.output;
  EXPECT_TRUE(result.says("6 beams: 6 valid")) << result.output;
}

TEST_F(ConvertCommand, ReplacesABagOnlyIfTold) {
  const std::string log = folder_.write("test.log", small_log());
  EXPECT_EQ(falko({"convert", log, bag_}).exit_code, 0);
  const auto refused = falko({"convert", log, bag_});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.errors, "falko: " + bag_ + ": exists already\n");
  EXPECT_EQ(falko({"convert", log, bag_, "--force"}).exit_code, 0);
}

TEST_F(ConvertCommand, NamesALogThatIsNone) {
  for (const std::string& log :
       {folder_.file("missing.log"), folder_.write("empty.log", ""), folder_.path()}) {
    const auto result = falko({"convert", log, bag_});
    EXPECT_EQ(result.exit_code, 1) << log;
    EXPECT_EQ(result.error_lines(), 1) << result.errors;
    EXPECT_TRUE(result.complains("falko: " + log + ": ")) << result.errors;
  }
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"empty.log"}));
}

}  // namespace
}  // namespace falko_slam
