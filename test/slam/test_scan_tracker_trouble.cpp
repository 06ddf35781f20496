// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tracker where scans or odometry fail it.
#include <gtest/gtest.h>

#include <cmath>

#include "support/hand_made_scans.hpp"
#include "support/tracked_drives.hpp"

namespace falko_slam {
namespace {

Scene endless_corridor() {
  Scene scene;
  scene.walls = {{{-500.0, 1.2}, {500.0, 1.2}}, {{-500.0, -1.2}, {500.0, -1.2}}};
  return scene;
}

LaserScan empty_scan() { return test::round_scan(test::kNoRange); }

test::SlamDrive office_drive(std::mt19937_64& random) {
  return test::slam_drive(office_scene(), test::straight({-8.0, -1.0, 0.0}, 8.0, 0.1), random);
}

// Nothing tells how far along: odometry does, and the covariance says that it is no better.
TEST(ScanTracker, FollowsOdometryAlongACorridorWithoutFeatures) {
  auto random = test::seeded_random();
  auto drive = test::slam_drive(endless_corridor(), test::straight({}, 10.0, 0.1), random, 720);
  test::mistake_steps(drive, [&](const Pose2& step) {
    return Pose2(1.1 * step.x(), 0.0, test::normal(random, 0.01));
  });
  const auto tracked = test::follow(drive);
  const Pose2 way = tracked.front().track_T_laser.inverse() * tracked.back().track_T_laser;
  const Pose2 truth =
      test::true_laser(drive, 0).inverse() * test::true_laser(drive, drive.size() - 1);
  const Eigen::Vector2d error = Pose2(0.0, 0.0, test::kLaserMount.theta()).rotation() *
                                (way.translation() - truth.translation());
  EXPECT_NEAR(error.x(), 1.0, 0.3);
  EXPECT_NEAR(error.y(), 0.0, 0.05);
  EXPECT_NEAR(way.theta(), truth.theta(), 0.01);
  for (std::size_t i = 1; i < tracked.size(); ++i) {
    if (!tracked[i].keyframe) continue;
    const Eigen::Matrix2d axes = Pose2(0.0, 0.0, -test::kLaserMount.theta()).rotation();
    const Eigen::Matrix2d covariance =
        axes.transpose() * tracked[i].keyframe_T_laser.covariance.topLeftCorner<2, 2>() * axes;
    EXPECT_GT(std::sqrt(covariance(0, 0)), 0.04) << i;
    EXPECT_LT(std::sqrt(covariance(1, 1)), 0.02) << i;
  }
}

TEST(ScanTracker, MakesNoKeyframeOfAnEmptyScan) {
  auto random = test::seeded_random();
  auto drive = office_drive(random);
  for (std::size_t i = 0; i < 3; ++i) drive[i].scan.scan = empty_scan();
  for (std::size_t i = 30; i < 40; ++i) drive[i].scan.scan = empty_scan();
  const auto tracked = test::follow(drive);
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const bool empty = i < 3 || (i >= 30 && i < 40);
    EXPECT_EQ(tracked[i].lost, empty) << i;
    if (empty) {
      EXPECT_FALSE(tracked[i].keyframe) << i;
    }
  }
  EXPECT_TRUE(tracked[3].keyframe);
  EXPECT_LT(test::greatest_drift(tracked, drive, 30), 0.05);
}

TEST(ScanTracker, SaysWithItsCovarianceThatItIsLost) {
  auto random = test::seeded_random();
  auto drive = office_drive(random);
  for (std::size_t i = 30; i < 40; ++i) drive[i].scan.scan = empty_scan();
  const auto tracked = test::follow(drive);
  for (std::size_t i = 31; i < 40; ++i) {
    EXPECT_GT(tracked[i].keyframe_T_laser.covariance.trace(),
              tracked[i - 1].keyframe_T_laser.covariance.trace());
  }
  EXPECT_LT(tracked[40].keyframe_T_laser.covariance.trace(),
            0.1 * tracked[39].keyframe_T_laser.covariance.trace());
}

TEST(ScanTracker, SurvivesAnOdometryThatWasReset) {
  auto random = test::seeded_random();
  for (const double jump : {-50.0, 7.0, 1000.0}) {
    auto drive = office_drive(random);
    for (std::size_t i = 40; i < drive.size(); ++i) {
      drive[i].scan.odom_T_base = Pose2(jump, 3.0, 2.0) * *drive[i].scan.odom_T_base;
    }
    const auto tracked = test::follow(drive);
    EXPECT_LT(test::greatest_drift(tracked, drive, 30), 0.03) << jump;
    EXPECT_EQ(test::count(tracked, &TrackedScan::lost), 0U) << jump;
  }
}

TEST(ScanTracker, ForgetsAllWhenItIsReset) {
  auto random = test::seeded_random();
  const auto drive = office_drive(random);
  ScanTracker tracker;
  tracker.track(drive[0].scan.scan, drive[0].scan.stamp, Pose2());
  tracker.keep(drive[0].scan.scan);
  tracker.reset();
  const TrackedScan next = tracker.track(drive[30].scan.scan, drive[30].scan.stamp, Pose2(7, 0, 0));
  EXPECT_TRUE(next.keyframe);
  EXPECT_EQ(next.track_T_laser.x(), 7.0);
}

}  // namespace
}  // namespace falko_slam
