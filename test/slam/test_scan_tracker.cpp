// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/scan_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/slam_drives.hpp"
#include "support/tracked_drives.hpp"

namespace falko_slam {
namespace {

// Of the way over 3 m [m].
double drift(const std::vector<TrackedScan>& tracked, const test::SlamDrive& drive) {
  return test::greatest_drift(tracked, drive, 30);
}

class ScanTrackerInTheOffice : public ::testing::Test {
 protected:
  std::mt19937_64 random_ = test::seeded_random();
  test::SlamDrive drive_ = test::slam_drive(office_scene(), office_path(0.1), random_);
};

TEST_F(ScanTrackerInTheOffice, FollowsAnExactOdometry) {
  const auto tracked = test::follow(drive_);
  EXPECT_LT(drift(tracked, drive_), 0.03);
  EXPECT_EQ(test::count(tracked, &TrackedScan::lost), 0U);
  EXPECT_EQ(test::count(tracked, &TrackedScan::searched), 0U);
}

TEST_F(ScanTrackerInTheOffice, MendsANoisyOdometry) {
  test::mistake_steps(drive_, [&](const Pose2& step) {
    return Pose2(1.1 * step.x() + test::normal(random_, 0.02), test::normal(random_, 0.01),
                 step.theta() + test::normal(random_, 0.02));
  });
  const auto tracked = test::follow(drive_);
  EXPECT_LT(drift(tracked, drive_), 0.03);
  EXPECT_EQ(test::count(tracked, &TrackedScan::lost), 0U);
}

TEST_F(ScanTrackerInTheOffice, NeedsNoOdometry) {
  test::forget_odometry(drive_);
  const auto tracked = test::follow(drive_);
  EXPECT_LT(drift(tracked, drive_), 0.03);
  EXPECT_EQ(test::count(tracked, &TrackedScan::lost), 0U);
}

TEST_F(ScanTrackerInTheOffice, FillsTheGapsOfAnOdometry) {
  for (std::size_t i = 50; i < drive_.size(); ++i) {
    if (i % 50 < 15) drive_[i].scan.odom_T_base.reset();
  }
  EXPECT_LT(drift(test::follow(drive_), drive_), 0.03);
}

TEST_F(ScanTrackerInTheOffice, CorrectsAnOdometryThatLags) {
  for (std::size_t i = drive_.size() - 1; i > 1; --i) {
    drive_[i].scan.odom_T_base = drive_[i - 2].scan.odom_T_base;
  }
  EXPECT_LT(drift(test::follow(drive_), drive_), 0.03);
}

TEST(ScanTracker, CorrectsAnOdometryWithTheWrongSignInReverse) {
  auto random = test::seeded_random();
  const auto there = test::straight({-8.0, -1.0, 0.0}, 5.0, 0.1);
  const auto back = test::straight({-3.0, -1.0, 0.0}, -4.0, 0.1);
  const auto again = test::straight({-7.0, -1.0, 0.0}, 3.0, 0.1);
  auto drive =
      test::slam_drive(office_scene(), test::joined(test::joined(there, back), again), random);
  test::mistake_steps(
      drive, [](const Pose2& step) { return Pose2(std::abs(step.x()), step.y(), step.theta()); });
  const auto tracked = test::follow(drive);
  EXPECT_GT(test::greatest_odometry_error(drive), 7.9);
  EXPECT_LT(drift(tracked, drive), 0.03);
  EXPECT_EQ(test::count(tracked, &TrackedScan::lost), 0U);
}

TEST_F(ScanTrackerInTheOffice, MakesAKeyframeOfEveryHalfMetre) {
  const auto tracked = test::follow(drive_);
  Pose2 last;
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    const Pose2 way = last.inverse() * tracked[i].track_T_laser;
    if (i > 0) {
      const bool far = way.translation().norm() >= 0.5 || std::abs(way.theta()) >= 0.5;
      EXPECT_EQ(tracked[i].keyframe, far) << i;
    }
    if (tracked[i].keyframe) last = tracked[i].track_T_laser;
  }
}

TEST_F(ScanTrackerInTheOffice, BeginsWhereOdometryIs) {
  const auto tracked = test::follow(drive_);
  EXPECT_TRUE(tracked.front().keyframe);
  EXPECT_LT(test::distance(tracked.front().track_T_laser,
                           drive_.front().world_T_base * test::kLaserMount),
            1e-12);
  test::forget_odometry(drive_);
  EXPECT_EQ(test::follow(drive_).front().track_T_laser.translation(), Eigen::Vector2d::Zero());
}

TEST(ScanTrackerParams, NamesFieldAndValueOfWhatIsWrong) {
  ScanTrackerParams params;
  params.free_turn = std::numeric_limits<double>::quiet_NaN();
  try {
    ScanTracker tracker(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("free_turn = nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace falko_slam
