// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/scan_motion_estimator.hpp"

#include <gtest/gtest.h>

#include "falko_slam/calibration/scan_motion.hpp"
#include "walled_halls.hpp"

namespace falko_slam {
namespace {

using test::HallDrive;

constexpr double kUnlikely = 16.3;  // chi2 of three degrees of freedom, 99.9 %

TEST(ScanMotion, IsExactWithoutNoise) {
  auto random = test::seeded_random();
  HallDrive drive;
  drive.laser = test::hall_laser(0.0);
  auto estimator = drive.driven(random);
  const auto motion = estimator.result();

  ASSERT_TRUE(motion) << estimator.complaint();
  const Eigen::Vector3d error = test::error_of(motion->start_T_end.pose, Pose2::exp(drive.arc));
  EXPECT_LT(error.head<2>().norm(), 2e-4);
  EXPECT_LT(std::abs(error.z()), 2e-5);
  EXPECT_NEAR(std::abs(motion->turn), kPi, 1e-4);
  EXPECT_EQ(motion->links, 1U);
  EXPECT_EQ(motion->scans, 42U);
  EXPECT_EQ(estimator.lost_scans(), 0U);
}

TEST(ScanMotion, ErrsAsMuchAsItsCovarianceSays) {
  auto random = test::seeded_random();
  ScanMotionParams params;
  params.registration.lasting_noise = 0.0;
  params.range_noise = 0.008;
  constexpr int kTrials = 20;
  double squares = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    HallDrive drive;
    drive.arc *= test::uniform(random, 0.3, 1.3) * (trial % 2 == 0 ? 1.0 : -1.0);
    drive.world_T_start = Pose2(1.0, -1.0, test::uniform(random, -kPi, kPi));
    auto estimator = drive.driven(random, params);
    const auto motion = estimator.result();
    ASSERT_TRUE(motion) << trial << ": " << estimator.complaint();
    squares += test::squared_error(motion->start_T_end, Pose2::exp(drive.arc)) / kTrials;
    EXPECT_NEAR(motion->turn, drive.arc.z(), 1e-3);
  }
  EXPECT_GT(squares, 1.5);
  EXPECT_LT(squares, 5.2);
}

TEST(ScanMotion, CountsWholeTurns) {
  auto random = test::seeded_random();
  HallDrive drive;
  drive.arc = {12.0, 0.0, -7.5};
  drive.world_T_start = Pose2(1.0, 1.0, 0.0);
  drive.scans_on_the_way = 60;
  auto estimator = drive.driven(random);
  const auto motion = estimator.result();

  ASSERT_TRUE(motion) << estimator.complaint();
  EXPECT_NEAR(motion->turn, -7.5, 0.001);
}

// Half a turn of a laser that sees half of the circle: what it sees at the end it has not seen at
// the start.
TEST(ScanMotion, LeadsOverScansOnTheWayWhereBothEndsSeeNothingAlike) {
  auto random = test::seeded_random();
  HallDrive drive;
  drive.laser = test::hall_laser(0.008, kPi);
  const auto wide = HallDrive().driven(random).result();
  for (int trial = 0; trial < 5; ++trial) {
    auto estimator = drive.driven(random);
    const auto motion = estimator.result();

    ASSERT_TRUE(wide && motion) << estimator.complaint();
    EXPECT_GE(motion->links, 2U);
    EXPECT_LT(test::squared_error(motion->start_T_end, Pose2::exp(drive.arc)), kUnlikely);
    EXPECT_GT(motion->start_T_end.covariance.trace(), 4.0 * wide->start_T_end.covariance.trace());
  }
}

TEST(ScanMotion, HasNoNumberWhereNothingIsSeenAlike) {
  auto random = test::seeded_random();
  HallDrive drive;
  drive.laser = test::hall_laser(0.008, kPi);
  drive.scans_on_the_way = 0;
  auto estimator = drive.driven(random);
  EXPECT_FALSE(estimator.result());
  EXPECT_NE(estimator.complaint().find("too few"), std::string::npos) << estimator.complaint();
}

TEST(ScanMotion, HasNoNumberInACorridor) {
  auto random = test::seeded_random();
  HallDrive drive;
  drive.start.walls = {{{-300.0, 7.0}, {300.0, 7.0}}, {{300.0, -7.0}, {-300.0, -7.0}}};
  drive.end = drive.start;
  for (int trial = 0; trial < 3; ++trial) {
    auto estimator = drive.driven(random);
    EXPECT_FALSE(estimator.result());
    EXPECT_NE(estimator.complaint().find("leave the motion open"), std::string::npos)
        << estimator.complaint();
  }
}

TEST(ScanMotion, IsNotMisledByWhatHasMoved) {
  auto random = test::seeded_random();
  HallDrive drive;
  for (std::size_t i = 4; i < 12; ++i) {  // two boxes
    drive.end.walls[i].from.y() += 0.02;
    drive.end.walls[i].to.y() += 0.02;
  }
  auto estimator = drive.driven(random);
  const auto motion = estimator.result();

  ASSERT_TRUE(motion) << estimator.complaint();
  EXPECT_LT(test::squared_error(motion->start_T_end, Pose2::exp(drive.arc)), kUnlikely);
}

TEST(ScanMotion, SeesPastWhatBlocksHalfOfTheView) {
  auto random = test::seeded_random();
  HallDrive drive;
  const Pose2 world_T_end = drive.world_T_start * Pose2::exp(drive.arc);
  drive.end.add_box(world_T_end * Pose2(2.0, 0.0, 0.1), {0.5, 9.0});
  auto estimator = drive.driven(random);
  const auto motion = estimator.result();

  ASSERT_TRUE(motion) << estimator.complaint();
  EXPECT_LT(test::squared_error(motion->start_T_end, Pose2::exp(drive.arc)), kUnlikely);
}

TEST(ScanMotion, HasNoNumberWhereMostIsElsewhere) {
  auto random = test::seeded_random();
  HallDrive drive;
  drive.end = Scene();
  drive.end.add_box({-1.0, 2.0, 0.6}, {24.0, 19.0});
  auto estimator = drive.driven(random);
  EXPECT_FALSE(estimator.result());
  EXPECT_FALSE(estimator.complaint().empty());
}

TEST(ScanMotion, SaysWhyThereIsNone) {
  ScanMotionEstimator nothing;
  EXPECT_FALSE(nothing.result());
  EXPECT_EQ(nothing.complaint(),
            "the straight walls seen at both ends, and on the way, are too few");

  auto random = test::seeded_random();
  HallDrive drive;
  drive.end = Scene();  // all beams without an echo
  auto estimator = drive.driven(random);
  EXPECT_FALSE(estimator.result());

  ScanMotionEstimator empty;
  empty.add_at_start(LaserScan());
  empty.add_on_the_way(LaserScan(), Pose2(0.5, 0.0, 0.1), {});
  empty.add_at_end(LaserScan(), Pose2(0.5, 0.0, 0.1));
  EXPECT_FALSE(empty.result());
  EXPECT_EQ(empty.lost_scans(), 1U);
}

TEST(ScanMotion, GoesOnByTheEncodersWhereScansAreMissing) {
  auto random = test::seeded_random();
  const HallDrive drive;
  const Pose2 step = Pose2::exp(drive.arc / 20.0);
  ScanMotionEstimator estimator;
  for (const LaserScan& scan :
       test::scans_at_rest(drive.start, drive.world_T_start, drive.laser, random)) {
    estimator.add_at_start(scan);
  }
  for (int i = 1; i < 20; ++i) {
    const Pose2 here = drive.world_T_start * Pose2::exp(i / 20.0 * drive.arc);
    const bool blind = i > 8 && i < 12;
    estimator.add_on_the_way(blind ? LaserScan() : drive.laser.scan(drive.start, here, {}, random),
                             step, {Pose2(), test::kRevolution});
  }
  for (const LaserScan& scan : test::scans_at_rest(
           drive.start, drive.world_T_start * Pose2::exp(drive.arc), drive.laser, random)) {
    estimator.add_at_end(scan, step);
  }
  const auto motion = estimator.result();

  ASSERT_TRUE(motion) << estimator.complaint();
  EXPECT_EQ(estimator.lost_scans(), 3U);
  EXPECT_LT(test::squared_error(motion->start_T_end, Pose2::exp(drive.arc)), kUnlikely);
}

TEST(ScanMotion, RefusesBadParameters) {
  ScanMotionParams params;
  params.range_noise = 0.0;
  EXPECT_THROW(ScanMotionEstimator{params}, std::invalid_argument);
  params = {};
  params.min_parts = 1;
  EXPECT_THROW(ScanMotionEstimator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
