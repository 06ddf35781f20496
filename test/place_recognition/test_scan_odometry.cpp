// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/drives.hpp"
#include "support/hand_made_scans.hpp"
#include "support/numbers.hpp"

namespace falko_slam {
namespace {

// An odometry with steps a tenth too long that turns by 2 degrees a step.
Pose2 worn(const Pose2& step) {
  return {1.1 * step.translation(), step.theta() + degrees_to_radians(2.0)};
}

double error_after(const Pose2& step, const Pose2& truth) {
  return (truth.inverse() * step).translation().norm();
}

TEST(ScanOdometry, TakesTheFirstPoseAsItIs) {
  auto random = test::seeded_random();
  const LaserScan scan = test::closed_scan(office_scene(), {}, 360, 0.01, random);
  const Pose2 pose = ScanOdometry().add(ScanView(scan), {3.0, -1.0, 2.0});
  EXPECT_EQ(pose.translation(), Eigen::Vector2d(3.0, -1.0));
  EXPECT_EQ(pose.theta(), 2.0);
}

TEST(ScanOdometry, MendsTheStepsOfAWornOdometry) {
  auto random = test::seeded_random();
  const auto scans = test::drive(office_scene(), office_path(0.3), random);
  const Pose2 start(5.0, 4.0, -2.0);
  ScanOdometry odometry;
  Pose2 odom = start;
  Pose2 first = odometry.add(ScanView(scans[0].scan), odom);
  std::vector<Pose2> mended = {first};
  std::vector<Pose2> raw = {odom};
  for (std::size_t i = 1; i < scans.size(); ++i) {
    odom = odom * worn(scans[i - 1].map_T_laser.inverse() * scans[i].map_T_laser);
    raw.push_back(odom);
    mended.push_back(odometry.add(ScanView(scans[i].scan), odom));
  }
  // Over three metres of way, as far as neighbours are asked.
  double worst = 0.0;
  double worst_raw = 0.0;
  for (std::size_t i = 0; i + 10 < scans.size(); ++i) {
    const Pose2 truth = scans[i].map_T_laser.inverse() * scans[i + 10].map_T_laser;
    worst = std::max(worst, error_after(mended[i].inverse() * mended[i + 10], truth));
    worst_raw = std::max(worst_raw, error_after(raw[i].inverse() * raw[i + 10], truth));
  }
  EXPECT_GT(worst_raw, 0.4);
  EXPECT_LT(worst, 0.05);
}

TEST(ScanOdometry, KeepsTheStepWhereScansTellNothing) {
  const Pose2 step(0.3, 0.1, 0.2);
  ScanOdometry odometry;
  odometry.add(ScanView(test::round_scan(test::kNoRange)), {1.0, 0.0, 0.5});
  const Pose2 pose =
      odometry.add(ScanView(test::round_scan(test::kNoRange)), Pose2(1.0, 0.0, 0.5) * step);
  EXPECT_LT(error_after(pose, Pose2(1.0, 0.0, 0.5) * step), 1e-12);
}

// Two endless walls: nothing says how far along.
TEST(ScanOdometry, KeepsTheStepInACorridor) {
  Scene corridor;
  corridor.walls = {{{-500.0, 1.0}, {500.0, 1.0}}, {{-500.0, -1.0}, {500.0, -1.0}}};
  const Pose2 truth(0.3, 0.0, 0.0);
  const Pose2 told(0.36, 0.02, 0.01);
  for (const double noise : {0.0, 0.01}) {
    auto random = test::seeded_random();
    ScanOdometry odometry;
    odometry.add(ScanView(test::closed_scan(corridor, {}, 1440, noise, random)), {});
    const Pose2 pose =
        odometry.add(ScanView(test::closed_scan(corridor, truth, 1440, noise, random)), told);
    EXPECT_LT(error_after(pose, told), 1e-12) << noise;
  }
}

TEST(ScanOdometry, KeepsTheStepWhereTheScansDisagree) {
  auto random = test::seeded_random();
  Scene elsewhere;
  elsewhere.add_box({0.5, 0.3, 0.7}, {3.0, 1.5});
  ScanOdometry odometry;
  odometry.add(ScanView(test::closed_scan(test::room_with_pillar(), {}, 360, 0.01, random)), {});
  const Pose2 step(0.2, 0.0, 0.0);
  const Pose2 pose =
      odometry.add(ScanView(test::closed_scan(elsewhere, {}, 360, 0.01, random)), step);
  EXPECT_LT(error_after(pose, step), 1e-12);
}

TEST(ScanOdometry, DoesNotLookBackOverAReset) {
  auto random = test::seeded_random();
  const LaserScan scan = test::closed_scan(test::room_with_pillar(), {}, 360, 0.01, random);
  ScanOdometry odometry;
  odometry.add(ScanView(scan), {});
  odometry.reset();
  EXPECT_EQ(odometry.add(ScanView(scan), {0.2, 0.0, 0.0}).x(), 0.2);
}

TEST(ScanOdometryParams, NamesFieldAndValueOfWhatIsWrong) {
  ScanOdometryParams params;
  params.min_agreement = test::kNaN;
  try {
    ScanOdometry odometry(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("min_agreement = nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace falko_slam
