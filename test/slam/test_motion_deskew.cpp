// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/motion_deskew.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/moving_scans.hpp"
#include "support/slam_drives.hpp"

namespace falko_slam {
namespace {

// From rest around the office at 1.2 m/s, swaying to either side at up to 0.8 rad/s.
test::Poses swaying_path(double step) {
  test::Poses path = office_path(step);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double way = step * static_cast<double>(i);
    path[i] = path[i] * Pose2(0.0, 0.0, 0.5 * (1.0 - std::cos(1.3 * way)));
  }
  path.insert(path.begin(), 3, path.front());
  return path;
}

// Around a pillar of the office at 1 m/s and 1 rad/s.
test::Poses round_path() {
  test::Poses path;
  for (int i = 0; i < 40; ++i) {
    path.push_back(Pose2(-6.0, -1.0, 0.0) * Pose2::exp(0.125 * i * Eigen::Vector3d(1.0, 0.0, 1.0)));
  }
  return path;
}

// Scans that take as long as the way from one to the next.
test::SlamDrive rolling_drive(const test::Poses& path, std::mt19937_64& random) {
  test::SlamDrive drive;
  test::MovingLaser laser = test::moving_laser(720, 0.01);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    laser.stamp = test::scan_time(i);
    const Pose2 here = path[i] * test::kLaserMount;
    const Pose2 next = path[i + 1] * test::kLaserMount;
    SlamScan scan{laser.stamp, {}, path[i], test::kLaserMount};
    scan.scan = laser.scan(office_scene(), here, here.inverse() * next, random);
    drive.push_back({std::move(scan), path[i]});
  }
  return drive;
}

double median_difference(const LaserScan& a, const LaserScan& b) {
  const auto differences = test::range_differences(a, b);
  return differences[differences.size() / 2];
}

TEST(MotionDeskew, TakesTheMotionOfTheOdometry) {
  auto random = test::seeded_random();
  const auto drive = rolling_drive(round_path(), random);
  MotionDeskew motion;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const SlamScan& taken = drive[i].scan;
    const Pose2 pose = drive[i].world_T_base * test::kLaserMount;
    const LaserScan scan = motion.apply(taken.scan, taken.stamp, pose);
    const LaserScan at_rest = test::moving_laser(720, 0.0).scan(office_scene(), pose, {}, random);
    if (i == 0) {
      EXPECT_EQ(scan.time_increment, taken.scan.time_increment);
      continue;
    }
    EXPECT_EQ(scan.time_increment, Duration::zero());
    EXPECT_LT(median_difference(scan, at_rest), 0.008) << i;
  }
}

TEST(MotionDeskew, TakesTheMotionThatWasFoundWhereThereIsNoOdometry) {
  auto random = test::seeded_random();
  const auto drive = rolling_drive(round_path(), random);
  MotionDeskew with, without;
  for (std::size_t i = 0; i < 20; ++i) {
    const SlamScan& taken = drive[i].scan;
    const Pose2 pose = drive[i].world_T_base * test::kLaserMount;
    const LaserScan a = with.apply(taken.scan, taken.stamp, pose);
    const LaserScan b = without.apply(taken.scan, taken.stamp, std::nullopt);
    without.found(pose);
    EXPECT_EQ(b.time_increment == Duration::zero(), i >= 3) << i;
    if (i >= 3) {
      EXPECT_LT(median_difference(a, b), 0.01) << i;
    }
  }
  without.reset();
  const SlamScan& taken = drive[20].scan;
  EXPECT_NE(without.apply(taken.scan, taken.stamp, std::nullopt).time_increment, Duration::zero());
}

TEST(MotionDeskew, DoesNotBelieveInJumpsAndGaps) {
  auto random = test::seeded_random();
  const LaserScan scan = test::moving_laser(360, 0.01).scan(office_scene(), {}, {}, random);
  const auto is_left = [&](const Pose2& way, Duration gap) {
    MotionDeskew motion;
    motion.apply(scan, test::scan_time(0), Pose2());
    return motion.apply(scan, test::scan_time(0) + gap, way).time_increment == scan.time_increment;
  };
  EXPECT_FALSE(is_left({0.1, 0.0, 0.1}, std::chrono::milliseconds(125)));
  EXPECT_TRUE(is_left({5.0, 0.0, 0.1}, std::chrono::milliseconds(125)));
  EXPECT_TRUE(is_left({0.1, 0.0, 2.0}, std::chrono::milliseconds(125)));
  EXPECT_TRUE(is_left({0.1, 0.0, 0.1}, std::chrono::milliseconds(0)));
  EXPECT_TRUE(is_left({0.1, 0.0, 0.1}, std::chrono::milliseconds(-125)));
  EXPECT_TRUE(is_left({0.1, 0.0, 0.1}, std::chrono::seconds(3)));
}

// Mean error of all scans' poses after the drive [m].
double mean_error(const test::SlamDrive& drive, bool deskewed) {
  SlamParams params;
  params.deskew = deskewed;
  FeatureSlam slam(params);
  const auto steps = test::run(slam, drive);
  slam.finish();
  EXPECT_EQ(std::count_if(steps.begin(), steps.end(), [](const auto& step) { return step.lost; }),
            0);
  double sum = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    sum += test::distance(slam.map_T_laser(*steps[i].keyframe) * steps[i].keyframe_T_base,
                          drive[i].world_T_base);
  }
  return sum / static_cast<double>(steps.size());
}

TEST(FeatureSlam, IsClearlyMoreAccurateDeskewed) {
  auto random = test::seeded_random();
  auto drive = rolling_drive(swaying_path(0.15), random);
  test::let_drift(drive, random);
  const double with = mean_error(drive, true), without = mean_error(drive, false);
  RecordProperty("mean_error_with_mm", static_cast<int>(1000.0 * with));
  RecordProperty("mean_error_without_mm", static_cast<int>(1000.0 * without));
  EXPECT_LT(with, 0.02);
  EXPECT_LT(with, 0.5 * without) << with << " and " << without;
}

// Errors of the motion that was found must not feed on themselves.
TEST(FeatureSlam, IsClearlyMoreAccurateDeskewedByItsOwnMotion) {
  auto random = test::seeded_random();
  auto drive = rolling_drive(swaying_path(0.15), random);
  const Pose2 world_T_map = drive.front().world_T_base;
  for (test::SlamInput& input : drive) {
    input.world_T_base = world_T_map.inverse() * input.world_T_base;
  }
  test::forget_odometry(drive);
  const double with = mean_error(drive, true), without = mean_error(drive, false);
  RecordProperty("mean_error_with_mm", static_cast<int>(1000.0 * with));
  RecordProperty("mean_error_without_mm", static_cast<int>(1000.0 * without));
  EXPECT_LT(with, 0.03);
  EXPECT_LT(with, 0.5 * without) << with << " and " << without;
}

}  // namespace
}  // namespace falko_slam
