// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe_memory.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/drives.hpp"

namespace falko_slam {
namespace {

// An odometry that starts elsewhere and is worn: steps of a tenth too much, a turn with each.
std::vector<Pose2> worn_odometry(const std::vector<PosedScan>& scans, const Pose2& start) {
  std::vector<Pose2> poses = {start};
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const Pose2 step = scans[i - 1].map_T_laser.inverse() * scans[i].map_T_laser;
    poses.push_back(poses.back() * Pose2(1.1 * step.translation(), step.theta() + 0.02));
  }
  return poses;
}

class KeyframeMemoryTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto random = test::seeded_random();
    test::Poses path = office_path(0.4);
    path.resize(30);
    first_ = test::drive(office_scene(), path, random);
    for (Pose2& pose : path) pose = pose * Pose2(0.1, 0.15, 0.1);
    second_ = test::drive(office_scene(), path, random);
  }
  static void TearDownTestSuite() { first_ = second_ = {}; }

  static void drive(KeyframeMemory& memory, const std::vector<PosedScan>& scans,
                    const Pose2& start) {
    const auto odometry = worn_odometry(scans, start);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      KeyframeRecord record;
      record.stamp = Time(Duration(1000 * static_cast<std::int64_t>(i)));
      record.odom_T_laser = odometry[i];
      record.base_T_laser = {0.5, 0.0, 0.0};
      record.scan = scans[i].scan;
      memory.add(record);
    }
  }

  static inline std::vector<PosedScan> first_;
  static inline std::vector<PosedScan> second_;
};

TEST_F(KeyframeMemoryTest, KeepsTheOdometryAsItCame) {
  KeyframeMemory memory({});
  const Pose2 start(7.0, -3.0, 1.0);
  drive(memory, first_, start);
  const auto odometry = worn_odometry(first_, start);
  ASSERT_EQ(memory.records().size(), first_.size());
  for (std::size_t i = 0; i < first_.size(); ++i) {
    EXPECT_EQ(memory.record({i}).odom_T_laser.translation(), odometry[i].translation());
    EXPECT_EQ(memory.record({i}).drive, 0U);
  }
}

TEST_F(KeyframeMemoryTest, ClosesTheSecondDriveWithTheFirstInSpiteOfTheOdometry) {
  KeyframeMemory memory({});
  drive(memory, first_, {});
  memory.begin_drive();
  drive(memory, second_, {50.0, 0.0, 3.0});
  std::size_t closed = 0;
  for (std::size_t i = 0; i < second_.size(); ++i) {
    const LoopDetection detection = memory.detect({first_.size() + i});
    const LoopCandidate* loop = detection.accepted();
    if (loop == nullptr) continue;
    ++closed;
    ASSERT_LT(loop->target.value, first_.size());
    const Pose2 error =
        (first_[loop->target.value].map_T_laser * loop->target_T_source->pose).inverse() *
        second_[i].map_T_laser;
    EXPECT_LT(error.translation().norm(), 0.1);
  }
  EXPECT_GT(closed, second_.size() / 3);
}

TEST_F(KeyframeMemoryTest, IsTheSameAfterItsFile) {
  KeyframeMemory memory({});
  drive(memory, first_, {});
  memory.begin_drive();
  drive(memory, second_, {50.0, 0.0, 3.0});
  KeyframeMemory loaded({}, keyframes_from(to_bytes(memory.records())));

  ASSERT_EQ(loaded.records().size(), memory.records().size());
  for (std::size_t i = first_.size(); i < loaded.records().size(); ++i) {
    EXPECT_EQ(loaded.record({i}).drive, 1U);
    EXPECT_EQ(loaded.keyframe({i}).path, memory.keyframe({i}).path);
    const auto again = loaded.detect({i}).candidates;
    const auto before = memory.detect({i}).candidates;
    ASSERT_EQ(again.size(), before.size());
    for (std::size_t k = 0; k < again.size(); ++k) {
      EXPECT_EQ(again[k].target, before[k].target);
      EXPECT_EQ(again[k].score, before[k].score);
    }
  }
}

TEST_F(KeyframeMemoryTest, BeginsAnotherDriveAfterWhatWasLoaded) {
  KeyframeMemory memory({});
  drive(memory, first_, {});
  KeyframeMemory loaded({}, memory.records());
  EXPECT_EQ(loaded.drive(), 1U);
  drive(loaded, second_, {});
  EXPECT_EQ(loaded.keyframe({first_.size()}).drive, 1U);
  EXPECT_EQ(loaded.record({first_.size() - 1}).drive, 0U);
  EXPECT_EQ(loaded.record({first_.size()}).drive, 1U);
  EXPECT_EQ(loaded.keyframe({first_.size()}).path, 0.0);
}

TEST_F(KeyframeMemoryTest, LocatesAScan) {
  KeyframeMemory memory({});
  EXPECT_TRUE(memory.locate(second_[9].scan, 3).empty());
  drive(memory, first_, {});
  const auto places = memory.locate(second_[9].scan, 3);
  ASSERT_FALSE(places.empty());
  const Pose2 error =
      (first_[places[0].target.value].map_T_laser * places[0].target_T_source->pose).inverse() *
      second_[9].map_T_laser;
  EXPECT_LT(error.translation().norm(), 0.1);
}

TEST(LoopClosureParams, AreAllLookedAt) {
  const auto refused = [](const LoopClosureParams& params) {
    EXPECT_THROW(KeyframeMemory{params}, std::invalid_argument);
  };
  LoopClosureParams params;
  params.scan.min_range = -1.0;
  refused(params);
  params = {};
  params.selector.min_step = -1.0;
  refused(params);
  params = {};
  params.detector.odometry.max_move = -1.0;
  refused(params);
  params = {};
  params.detector.keyframe.view.max_range = -1.0;
  refused(params);
}

}  // namespace
}  // namespace falko_slam
