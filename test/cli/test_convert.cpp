// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include "support/bag_contents.hpp"
#include "support/carmen_lines.hpp"
#include "support/command.hpp"
#include "support/tricycle_lines.hpp"

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
  EXPECT_EQ(refused.errors, "falko: " + bag_ + ": exists already; --force replaces it\n");
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

TEST_F(ConvertCommand, KnowsTheLogOfATricycleByItsContent) {
  for (const char* name : {"test.log", "test.log.gz", "test.log.bz2"}) {
    const auto result =
        falko({"convert", folder_.write(name, test::small_tricycle_log()), bag_, "--force",
               "--odom-frame", "o", "--base-frame", "b", "--laser-frame", "l"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_TRUE(result.says("3 encoder readings with poses")) << result.output;
    EXPECT_TRUE(result.says("nominal values: wheelbase 1.4 m")) << result.output;
    EXPECT_FALSE(result.says("play later")) << result.output;
    EXPECT_EQ(test::bag_messages(bag_).size(), 16U) << name;
    const auto mounts = test::bag_messages_on<tf2_msgs::TFMessage>(bag_, "/tf_static");
    ASSERT_EQ(mounts.size(), 1U);
    EXPECT_EQ(mounts[0].transforms.at(0).header.frame_id, "b");
    EXPECT_EQ(mounts[0].transforms.at(0).child_frame_id, "l");
    const auto transforms = test::bag_messages_on<tf2_msgs::TFMessage>(bag_, "/tf");
    EXPECT_EQ(transforms.at(0).transforms.at(0).header.frame_id, "o");
  }
}

TEST_F(ConvertCommand, SaysHowManyMessagesOfATricycleWereMoved) {
  const std::string log = test::tricycle_header() +
                          test::tricycle_line("2", "1 1", "0 0 0", "0 0 0") +
                          test::tricycle_line("1", "1 1", "0 0 0", "0 0 0");
  const auto result = falko({"convert", folder_.write("test.log", log), bag_});
  EXPECT_TRUE(result.says("5 messages play later than their stamps say")) << result.output;
}

TEST_F(ConvertCommand, SaysThatALogIsOfNeitherKind) {
  const std::string log = folder_.write("neither.txt", "time flies\nlike an arrow\n");
  const auto result = falko({"convert", log, bag_});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.errors, "falko: " + log +
                               ": neither a CARMEN log nor a tricycle's log: none of 2 lines "
                               "begins as theirs do\n");
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"neither.txt"}));
}

}  // namespace
}  // namespace falko_slam
