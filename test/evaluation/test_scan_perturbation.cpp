// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/scan_perturbation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "falko_slam/geometry/pose2.hpp"
#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

using test::kNoRange;

// Range i + 1 for beam i; beam `invalid` has none.
LaserScan ramp(std::size_t beams, std::size_t invalid, bool closed) {
  std::vector<double> ranges;
  for (std::size_t i = 0; i < beams; ++i) ranges.push_back(static_cast<double>(i + 1));
  if (invalid < beams) ranges[invalid] = kNoRange;
  return closed ? test::circle_of(ranges) : test::scan_of(ranges, -1.0, 0.25);
}

constexpr std::size_t kNone = 1000;

TEST(WithNoise, HasTheStatedStandardDeviation) {
  auto random = test::seeded_random();
  constexpr std::size_t kBeams = 20000;
  const LaserScan scan = test::round_scan(5.0, kBeams);
  for (const double deviation : {0.01, 0.3}) {
    const LaserScan noisy = with_noise(scan, deviation, random);
    double mean = 0.0;
    double square = 0.0;
    for (const double range : noisy.ranges) {
      mean += (range - 5.0) / kBeams;
      square += (range - 5.0) * (range - 5.0) / kBeams;
    }
    // Four standard errors of a mean, and of a standard deviation relative to itself.
    EXPECT_NEAR(mean, 0.0, 4.0 * deviation / std::sqrt(kBeams));
    EXPECT_NEAR(std::sqrt(square) / deviation, 1.0, 4.0 / std::sqrt(2.0 * kBeams));
  }
}

TEST(WithNoise, LeavesInvalidBeamsAsTheyAre) {
  auto random = test::seeded_random();
  const LaserScan noisy = with_noise(ramp(8, 3, false), 0.1, random);
  EXPECT_FALSE(noisy.valid(3));
  EXPECT_TRUE(std::isnan(noisy.ranges[3]));
  EXPECT_NE(noisy.ranges[2], 3.0);
}

TEST(WithNoise, RangesStayPositive) {
  auto random = test::seeded_random();
  const LaserScan noisy = with_noise(test::round_scan(0.05, 1000), 1.0, random);
  EXPECT_EQ(*std::min_element(noisy.ranges.begin(), noisy.ranges.end()), 1e-3);
}

TEST(Subsampled, KeepsEveryNthBeamInItsDirection) {
  const LaserScan scan = ramp(10, 3, false);
  const LaserScan sparse = subsampled(scan, 2);
  ASSERT_EQ(sparse.size(), 4U);  // beams 0, 3, 6, 9
  for (std::size_t i = 0; i < sparse.size(); ++i) {
    EXPECT_NEAR(sparse.bearing(i), scan.bearing(3 * i), 1e-12);
    EXPECT_EQ(sparse.status[i], scan.status[3 * i]);
    EXPECT_TRUE(!scan.valid(3 * i) || sparse.ranges[i] == scan.ranges[3 * i]);
  }
}

TEST(Subsampled, ACircleStaysClosedOnlyIfItsSeamIsAsWideAsTheRest) {
  EXPECT_TRUE(subsampled(ramp(12, kNone, true), 2).closed);
  EXPECT_FALSE(subsampled(ramp(13, kNone, true), 2).closed);
  EXPECT_FALSE(subsampled(ramp(12, kNone, false), 2).closed);
}

TEST(Oversampled, InterpolatesBetweenNeighbors) {
  const LaserScan scan = ramp(3, kNone, false);
  const LaserScan dense = oversampled(scan, 3);
  EXPECT_EQ(dense.ranges, (std::vector<double>{1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0}));
  EXPECT_EQ(dense.status, std::vector<BeamStatus>(9, BeamStatus::kValid));
  for (std::size_t i = 0; i < scan.size(); ++i) {
    EXPECT_NEAR(dense.bearing(4 * i), scan.bearing(i), 1e-12);
  }
}

TEST(Oversampled, AddsNothingBesideAnInvalidBeam) {
  const LaserScan dense = oversampled(ramp(4, 1, false), 1);
  ASSERT_EQ(dense.size(), 7U);
  for (const std::size_t i : {1U, 2U, 3U}) {
    EXPECT_FALSE(dense.valid(i)) << i;
    EXPECT_TRUE(std::isnan(dense.ranges[i])) << i;
  }
  EXPECT_EQ(dense.ranges[5], 3.5);
}

TEST(Oversampled, ACircleIsFilledOverItsSeam) {
  const LaserScan dense = oversampled(ramp(4, kNone, true), 1);
  ASSERT_EQ(dense.size(), 8U);
  EXPECT_TRUE(dense.closed);
  EXPECT_EQ(dense.ranges[7], 2.5);  // between 4 and 1
  EXPECT_NEAR(dense.angle_increment * 8.0, kTwoPi, 1e-12);
}

TEST(Oversampled, SubsamplingTakesItBack) {
  for (const bool closed : {false, true}) {
    const LaserScan scan = ramp(9, kNone, closed);
    for (const std::size_t count : {1U, 2U, 4U}) {
      const LaserScan back = subsampled(oversampled(scan, count), count);
      EXPECT_EQ(back.ranges, scan.ranges);
      EXPECT_EQ(back.closed, scan.closed);
      EXPECT_NEAR(back.angle_increment, scan.angle_increment, 1e-12);
    }
  }
}

TEST(WithStartAngleTurned, TurnsEveryPoint) {
  const LaserScan scan = ramp(5, kNone, false);
  const LaserScan turned = with_start_angle_turned(scan, 0.7);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    EXPECT_LT((turned.point(i) - Pose2(0.0, 0.0, 0.7) * scan.point(i)).norm(), 1e-12);
  }
}

TEST(WithBeamsRotated, MovesWhatBelongsToABeamTogether) {
  LaserScan scan = ramp(5, 2, true);
  scan.intensities = {10.0F, 20.0F, 30.0F, 40.0F, 50.0F};
  const LaserScan rotated = with_beams_rotated(scan, 2);
  EXPECT_FALSE(rotated.valid(0));
  EXPECT_EQ(rotated.ranges[1], 4.0);
  EXPECT_EQ(rotated.ranges[4], 2.0);
  EXPECT_EQ(rotated.intensities, (std::vector<float>{30.0F, 40.0F, 50.0F, 10.0F, 20.0F}));
}

TEST(WithBeamsRotated, AFullTurnChangesNothing) {
  const LaserScan scan = ramp(5, kNone, true);
  EXPECT_EQ(with_beams_rotated(scan, 5).ranges, scan.ranges);
  EXPECT_EQ(with_beams_rotated(with_beams_rotated(scan, 3), 2).ranges, scan.ranges);
}

}  // namespace
}  // namespace falko_slam
