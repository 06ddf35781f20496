// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/topic_watch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

namespace falko_slam {
namespace {

constexpr char kScanType[] = "sensor_msgs/LaserScan";
constexpr char kCloudType[] = "sensor_msgs/PointCloud2";

const HeardTopic kScan{"/scan", kScanType};

TEST(SilenceCause, TellsNobodyFromTheWrongAndTheSilent) {
  EXPECT_EQ(silence_cause(kScan, {}), SilenceCause::kNoPublisher);
  EXPECT_EQ(silence_cause(kScan, {{"/scan", {kCloudType, {"/a"}}}}), SilenceCause::kWrongType);
  EXPECT_EQ(silence_cause(kScan, {{"/scan", {kScanType, {"/a"}}}}), SilenceCause::kNoMessage);
  EXPECT_EQ(silence_cause(kScan, {{"/scan", {"*", {"/a"}}}}), SilenceCause::kNoMessage);
}

TEST(SilenceCause, NamesPublishersAndTypes) {
  EXPECT_EQ(describe_silence(kScan, {}), "nobody publishes it");
  EXPECT_EQ(describe_silence(kScan, {{"/scan", {kScanType, {"/a", "/b"}}}}),
            "/a, /b should publish it, but is silent");
  EXPECT_EQ(describe_silence(kScan, {{"/scan", {kCloudType, {"/a"}}}}),
            "/a publishes it with type sensor_msgs/PointCloud2, expected sensor_msgs/LaserScan");
}

TEST(SilenceCause, SuggestsTopicsOfTheRightTypeFirstThoseNamedAlike) {
  const TopicDirectory directory{{"/front/laser", {kScanType, {"/a"}}},
                                 {"/points", {kCloudType, {"/a"}}},
                                 {"/sick/scan", {kScanType, {"/a"}}}};
  EXPECT_EQ(describe_silence(kScan, directory),
            "nobody publishes it (did you mean /sick/scan, /front/laser, of this type?)");
}

class TopicWatchTest : public ::testing::Test {
 protected:
  // The answer comes from another thread.
  std::string answered(double now) {
    std::string text;
    for (int i = 0; i < 1000 && !watch_.cause(); ++i) {
      text = watch_.trouble(now);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return watch_.trouble(now);
  }

  void master_says(std::optional<TopicDirectory> directory) {
    const std::lock_guard<std::mutex> lock(mutex_);
    directory_ = std::move(directory);
  }

  std::mutex mutex_;  // the master is asked by another thread
  std::optional<TopicDirectory> directory_ = TopicDirectory{};
  TopicWatch watch_{kScan, 100.0, 1.5, [this] {
                      const std::lock_guard<std::mutex> lock(mutex_);
                      return directory_;
                    }};
};

TEST_F(TopicWatchTest, IsContentWhileMessagesCome) {
  EXPECT_EQ(watch_.trouble(101.4), "");
  watch_.heard(101.4);
  EXPECT_EQ(watch_.trouble(102.8), "");
  EXPECT_FALSE(watch_.cause());
}

TEST_F(TopicWatchTest, NamesTopicAndCause) {
  EXPECT_EQ(answered(103.2), "no message on /scan for 3.2 s: nobody publishes it");
  watch_.heard(103.3);
  EXPECT_EQ(watch_.trouble(103.4), "");
  EXPECT_FALSE(watch_.cause());
}

TEST_F(TopicWatchTest, TellsTheConsoleOnceOfATopicThatNobodyPublishes) {
  watch_.heard(0.0);
  master_says(TopicDirectory{});
  answered(TopicWatch::kPatience);
  EXPECT_FALSE(watch_.told());
  answered(TopicWatch::kPatience + 1.0);
  EXPECT_TRUE(watch_.told());

  watch_.heard(7.0);
  EXPECT_FALSE(watch_.told());
  master_says(TopicDirectory{{"/scan", {kScanType, {"/a"}}}});
  answered(20.0);
  EXPECT_FALSE(watch_.told());  // a scanner that is off
}

TEST_F(TopicWatchTest, KeepsFromTheConsoleWhatMayBeSilent) {
  master_says(TopicDirectory{});
  watch_.keep_from_console();
  answered(120.0);
  EXPECT_EQ(watch_.cause(), SilenceCause::kNoPublisher);
  EXPECT_FALSE(watch_.told());
}

// Between two silences the system may have become another one.
TEST_F(TopicWatchTest, ForgetsWhatTheMasterSaidOfAnEarlierSilence) {
  answered(102.0);
  watch_.heard(102.1);
  master_says(TopicDirectory{{"/scan", {kScanType, {"/a"}}}});
  EXPECT_EQ(answered(105.1), "no message on /scan for 3.0 s: /a should publish it, but is silent");
}

TEST_F(TopicWatchTest, NamesTheTopicWithoutAnAnswerOfTheMaster) {
  master_says({});
  EXPECT_EQ(answered(102.0), "no message on /scan for 2.0 s");
}

// A report every second, at the worst moment: the master is asked in time.
TEST_F(TopicWatchTest, KnowsTheCauseWithinThreeSeconds) {
  EXPECT_EQ(watch_.trouble(100.74), "");
  answered(101.74);
  EXPECT_EQ(watch_.trouble(102.74), "no message on /scan for 2.7 s: nobody publishes it");
}

}  // namespace
}  // namespace falko_slam
