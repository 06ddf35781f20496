// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/slam_record.hpp"

#include <gtest/gtest.h>

#include "support/hand_made_scans.hpp"
#include "support/slam_drives.hpp"

namespace falko_slam {
namespace {

class SlamRecordOfADrive : public ::testing::Test {
 protected:
  void SetUp() override {
    auto random = test::seeded_random();
    drive_ = test::slam_drive(office_scene(), office_path(0.2), random, 180);
    test::let_drift(drive_, random);
    drive_[0].scan.scan = test::round_scan(test::kNoRange);
    drive_[30].scan.scan = test::round_scan(test::kNoRange);
    for (const test::SlamInput& input : drive_) {
      steps_.push_back(slam_.add(input.scan));
      record_.add(input.scan.stamp, steps_.back());
    }
  }

  FeatureSlam slam_;
  SlamRecord record_;
  test::SlamDrive drive_;
  std::vector<SlamStep> steps_;
};

TEST_F(SlamRecordOfADrive, HasOnePoseForEachScan) {
  const Trajectory online = record_.online();
  const Trajectory final = record_.final(slam_);
  ASSERT_EQ(record_.scans(), drive_.size());
  ASSERT_EQ(online.size(), drive_.size());
  ASSERT_EQ(final.size(), drive_.size());
  for (std::size_t i = 0; i < drive_.size(); ++i) {
    EXPECT_EQ(online[i].stamp, drive_[i].scan.stamp);
    EXPECT_EQ(final[i].stamp, drive_[i].scan.stamp);
    EXPECT_LT(test::distance(online[i].map_T_base, steps_[i].map_T_base), 1e-12) << i;
  }
  EXPECT_EQ(record_.lost(), 2U);
}

TEST_F(SlamRecordOfADrive, FollowsTheGraph) {
  slam_.finish();
  const Trajectory final = record_.final(slam_);
  for (std::size_t i = 1; i < drive_.size(); ++i) {
    const Pose2 expected = slam_.map_T_laser(*steps_[i].keyframe) * steps_[i].keyframe_T_base;
    EXPECT_LT(test::distance(final[i].map_T_base, expected), 1e-12) << i;
  }
}

TEST_F(SlamRecordOfADrive, TheMapHasTheWallsOfTheScene) {
  slam_.finish();
  const GridMap map = map_of(slam_);
  EXPECT_GT(map.width, 200U);
  EXPECT_GT(map.height, 100U);
}

TEST(SlamRecord, IsEmptyOfNothing) {
  const FeatureSlam slam;
  const SlamRecord record;
  EXPECT_TRUE(record.online().empty());
  EXPECT_TRUE(record.final(slam).empty());
  EXPECT_EQ(map_of(slam).width, 0U);
}

}  // namespace
}  // namespace falko_slam
