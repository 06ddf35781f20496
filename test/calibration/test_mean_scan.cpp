// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/mean_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "walled_halls.hpp"

namespace falko_slam {
namespace {

TEST(MeanScan, AveragesBeamByBeam) {
  auto random = test::seeded_random();
  const Pose2 pose(1.0, 0.5, 0.3);
  const LaserScan truth = test::hall_laser(0.0).scan(test::walled_hall(), pose, {}, random);
  std::vector<LaserScan> scans;
  for (int i = 0; i < 25; ++i) {
    scans.push_back(test::hall_laser(0.01).scan(test::walled_hall(), pose, {}, random));
  }

  const MeanScan mean = mean_of(scans);

  EXPECT_EQ(mean.scans, 25U);
  EXPECT_NEAR(mean.range_noise, 0.01, 0.0005);
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ASSERT_TRUE(mean.scan.valid(i)) << i;
    squares += std::pow(mean.scan.ranges[i] - truth.ranges[i], 2);
  }
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(truth.size())), 0.002, 0.0003);
}

TEST(MeanScan, LeavesOutBeamsThatAreSeldomValidOrWild) {
  auto random = test::seeded_random();
  std::vector<LaserScan> scans =
      test::scans_at_rest(test::walled_hall(), {}, test::hall_laser(0.005), random);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (i != 2) scans[i].status[7] = BeamStatus::kNoReturn;
    scans[i].ranges[9] += i % 2 == 0 ? 0.5 : 0.0;
    if (i == 0) scans[i].status[11] = BeamStatus::kErroneous;
  }

  const MeanScan mean = mean_of(scans);

  EXPECT_FALSE(mean.scan.valid(7));
  EXPECT_FALSE(mean.scan.valid(9));
  EXPECT_TRUE(std::isnan(mean.scan.ranges[9]));
  EXPECT_TRUE(mean.scan.valid(11));
  EXPECT_TRUE(std::isfinite(mean.scan.ranges[11]));
}

TEST(MeanScan, OfNothingIsEmpty) {
  EXPECT_EQ(mean_of({}).scan.size(), 0U);
  EXPECT_EQ(mean_of({LaserScan(), LaserScan()}).scan.size(), 0U);
}

TEST(MeanScan, LeavesOutScansOfAnotherSize) {
  auto random = test::seeded_random();
  std::vector<LaserScan> scans =
      test::scans_at_rest(test::walled_hall(), {}, test::hall_laser(0.005), random);
  scans.push_back(test::hall_laser(0.0, kPi).scan(test::walled_hall(), {}, {}, random));

  EXPECT_EQ(mean_of(scans).scans, 6U);
}

}  // namespace
}  // namespace falko_slam
