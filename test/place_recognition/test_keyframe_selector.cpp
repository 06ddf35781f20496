// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe_selector.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/numbers.hpp"

namespace falko_slam {
namespace {

using Choice = KeyframeSelector::Choice;

TEST(KeyframeSelector, TakesTheFirstScanWhereverItIs) {
  EXPECT_EQ(KeyframeSelector().choose({1e5, -3.0, 2.0}), Choice::kKeyframe);
}

TEST(KeyframeSelector, TakesAScanAfterTheStep) {
  KeyframeSelector selector;
  selector.choose({});
  EXPECT_EQ(selector.choose({0.15, 0.13, 0.0}), Choice::kPassOver);
  EXPECT_EQ(selector.choose({0.15, 0.14, 0.0}), Choice::kKeyframe);
  EXPECT_EQ(selector.choose({0.15, 0.14, 0.0}), Choice::kPassOver);
}

TEST(KeyframeSelector, TakesAScanAfterTheTurnAcrossPiToo) {
  KeyframeSelector selector;
  for (const double heading : {0.0, kPi - 0.1, -kPi + 0.1}) {
    selector.reset();
    EXPECT_EQ(selector.choose({0.0, 0.0, heading}), Choice::kKeyframe);
    EXPECT_EQ(selector.choose({0.0, 0.0, heading + 0.34}), Choice::kPassOver);
    EXPECT_EQ(selector.choose({0.0, 0.0, heading - 0.34}), Choice::kPassOver);
    EXPECT_EQ(selector.choose({0.0, 0.0, heading - 0.36}), Choice::kKeyframe);
  }
}

TEST(KeyframeSelector, DoesNotAddUpWaysThatLeadBack) {
  KeyframeSelector selector;
  selector.choose({});
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(selector.choose({i % 2 == 0 ? 0.1 : 0.0, 0.0, 0.0}), Choice::kPassOver);
  }
}

TEST(KeyframeSelector, ChoosesTheSameWhereverTheOdometryStarts) {
  const Pose2 start(-40.0, 12.0, 3.0);
  KeyframeSelector here;
  KeyframeSelector there;
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose(0.031 * i, 0.01 * i, 0.023 * i);
    EXPECT_EQ(here.choose(pose), there.choose(start * pose));
  }
}

TEST(KeyframeSelector, BeginsADriveWhenTheOdometryJumps) {
  KeyframeSelector selector;
  selector.choose({});
  EXPECT_EQ(selector.choose({4.9, 0.0, 0.0}), Choice::kKeyframe);
  EXPECT_EQ(selector.choose({-0.2, 0.0, 0.0}), Choice::kFirstOfNew);
  EXPECT_EQ(selector.choose({-0.3, 0.0, 0.0}), Choice::kPassOver);
}

TEST(KeyframeSelector, MeasuresJumpsFromScanToScan) {
  KeyframeSelectorParams params;
  params.min_step = 50.0;
  KeyframeSelector selector(params);
  selector.choose({});
  for (int i = 1; i < 12; ++i) EXPECT_EQ(selector.choose({4.0 * i, 0.0, 0.0}), Choice::kPassOver);
  EXPECT_EQ(selector.choose({52.0, 0.0, 0.0}), Choice::kFirstOfNew);
}

TEST(KeyframeSelector, PassesOverPosesThatAreNoneAndForgetsThem) {
  KeyframeSelector selector;
  EXPECT_EQ(selector.choose({test::kNaN, 0.0, 0.0}), Choice::kPassOver);
  EXPECT_EQ(selector.choose({0.0, 0.0, 0.0}), Choice::kKeyframe);
  EXPECT_EQ(selector.choose({0.0, std::numeric_limits<double>::infinity(), 0.0}),
            Choice::kPassOver);
  EXPECT_EQ(selector.choose({0.1, 0.0, 0.0}), Choice::kPassOver);
}

TEST(KeyframeSelector, TakesTheScanAfterAReset) {
  KeyframeSelector selector;
  selector.choose({});
  selector.reset();
  EXPECT_EQ(selector.choose({100.0, 0.0, 0.0}), Choice::kKeyframe);
}

TEST(KeyframeSelectorParams, NamesFieldAndValueOfWhatIsWrong) {
  KeyframeSelectorParams params;
  params.min_turn = test::kNaN;
  try {
    KeyframeSelector selector(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("min_turn = nan"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
