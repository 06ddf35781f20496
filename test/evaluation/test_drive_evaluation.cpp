// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/drive_evaluation.hpp"

#include <gtest/gtest.h>

#include "support/drives.hpp"

namespace falko_slam {
namespace {

// Twice along one way through the office, with an odometry that is worn: too long and to the left
// the first time, too short and to the right the second time. (The same error both times would bend
// both neighbourhoods alike.)
std::vector<DrivenScan> worn_drive() {
  auto random = test::seeded_random();
  const auto lap = office_path(0.5);
  test::Poses path = lap;
  for (std::size_t i = 0; i < 24; ++i) path.push_back(lap[i] * Pose2(0.1, 0.1, 0.05));
  std::vector<DrivenScan> scans;
  Pose2 odometry;
  Pose2 last = path[0];
  for (const PosedScan& posed : test::drive(office_scene(), path, random)) {
    const Pose2 step = last.inverse() * posed.map_T_laser;
    const double error = scans.size() < lap.size() ? 1.0 : -1.0;
    odometry =
        odometry * Pose2((1.0 + 0.1 * error) * step.translation(), step.theta() + 0.05 * error);
    last = posed.map_T_laser;
    scans.push_back({posed.scan, odometry, posed.map_T_laser});
  }
  return scans;
}

TEST(DriveEvaluation, FindsTheLoopsOfAWornOdometryOnlyWhereItIsRegistered) {
  const auto scans = worn_drive();
  const DriveResult corrected = evaluate_drive(scans, DrivePoses::kCorrected);
  const DriveResult odometry = evaluate_drive(scans, DrivePoses::kOdometry);
  const DriveResult registered = evaluate_drive(scans, DrivePoses::kRegistered);

  for (const DriveResult& result : {corrected, odometry, registered}) {
    EXPECT_EQ(result.keyframes, scans.size());
    EXPECT_GE(result.loops, 24U);
  }
  EXPECT_GT(corrected.accepted.recall, 0.5);
  EXPECT_GT(registered.accepted.recall, corrected.accepted.recall - 0.1);
  EXPECT_LT(odometry.accepted.recall, 0.5 * registered.accepted.recall);
}

TEST(DriveEvaluation, OfNothingIsNothing) {
  const DriveResult result = evaluate_drive({}, DrivePoses::kRegistered);
  EXPECT_EQ(result.keyframes, 0U);
  EXPECT_EQ(result.accepted.closures, 0U);
}

}  // namespace
}  // namespace falko_slam
