// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/deskew.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "support/hand_made_scans.hpp"
#include "support/moving_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// 1 m/s and 1 rad/s over a revolution, to either side.
const Pose2 kLeft = Pose2::exp({0.125, 0.0, 0.125});
const Pose2 kRight = Pose2::exp({-0.125, 0.02, -0.125});

double share_below(const std::vector<double>& sorted, double limit) {
  const auto end = std::lower_bound(sorted.begin(), sorted.end(), limit);
  return static_cast<double>(end - sorted.begin()) / static_cast<double>(sorted.size());
}

void expect_same(const LaserScan& a, const LaserScan& b) {
  EXPECT_EQ(a.first_beam_time, b.first_beam_time);
  EXPECT_EQ(a.time_increment, b.time_increment);
  EXPECT_EQ(a.status, b.status);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a.ranges[i] == b.ranges[i] || (std::isnan(a.ranges[i]) && std::isnan(b.ranges[i])));
  }
}

struct Case {
  Pose2 way;
  bool clockwise;
  double noise;
};

void PrintTo(const Case& how, std::ostream* out) {
  *out << how.way << (how.clockwise ? " clockwise, noise " : ", noise ") << how.noise;
}

class DeskewOfAMovingLaser : public ::testing::TestWithParam<Case> {};

// What is left is the noise, but at the edges of things, where a beam sees one or the other.
TEST_P(DeskewOfAMovingLaser, GivesWhatALaserAtRestWouldSee) {
  const Case& how = GetParam();
  auto random = test::seeded_random();
  test::MovingLaser laser = test::moving_laser(1440, how.noise);
  laser.clockwise = how.clockwise;
  const Pose2 pose(-3.0, -1.0, 0.7);
  const LaserScan skewed = laser.scan(office_scene(), pose, how.way, random);
  test::MovingLaser exact = test::moving_laser(1440, 0.0);
  exact.clockwise = how.clockwise;
  const LaserScan at_rest = exact.scan(office_scene(), pose, Pose2(), random);
  const LaserScan deskewed = deskew(skewed, {how.way, test::kRevolution}, laser.stamp);
  ASSERT_EQ(deskewed.size(), at_rest.size());
  ASSERT_EQ(deskewed.angle_min, at_rest.angle_min);
  EXPECT_EQ(deskewed.first_beam_time, laser.stamp);
  EXPECT_EQ(deskewed.time_increment, Duration::zero());
  const auto before = test::range_differences(skewed, at_rest);
  const auto after = test::range_differences(deskewed, at_rest);
  EXPECT_GT(after.size(), 1380U);
  const double tolerance = 3.5 * how.noise + 0.002;
  EXPECT_GT(share_below(after, tolerance), 0.95);
  EXPECT_LT(share_below(before, tolerance), 0.60);
  const double median = after[after.size() / 2];
  EXPECT_LT(median, 0.7 * how.noise + 0.0005);
  EXPECT_GT(before[before.size() / 2], 3.0 * median);
}
INSTANTIATE_TEST_SUITE_P(Motions, DeskewOfAMovingLaser,
                         ::testing::Values(Case{kLeft, false, 0.0}, Case{kRight, false, 0.0},
                                           Case{kLeft, true, 0.0}, Case{kRight, true, 0.0},
                                           Case{kLeft, false, 0.01}, Case{kRight, false, 0.01},
                                           Case{kLeft, true, 0.01}, Case{kRight, true, 0.01}));

TEST(Deskew, LeavesAScanAtRestAsItIs) {
  auto random = test::seeded_random();
  const test::MovingLaser laser = test::moving_laser(360, 0.01);
  const LaserScan scan = laser.scan(office_scene(), {}, kLeft, random);
  expect_same(deskew(scan, {Pose2(), test::kRevolution}, laser.stamp), scan);
  expect_same(deskew(scan, {kLeft, Duration::zero()}, laser.stamp), scan);
  LaserScan snapshot = scan;
  snapshot.time_increment = Duration::zero();
  expect_same(deskew(snapshot, {kLeft, test::kRevolution}, laser.stamp), snapshot);
  expect_same(deskew(LaserScan(), {kLeft, test::kRevolution}, laser.stamp), LaserScan());
}

TEST(Deskew, TakesAnyInstantOfTheScan) {
  auto random = test::seeded_random();
  const test::MovingLaser laser = test::moving_laser(1440, 0.0);
  const Pose2 pose(-3.0, -1.0, 0.7);
  const LaserScan skewed = laser.scan(office_scene(), pose, kLeft, random);
  for (const double share : {-1.0, 0.0, 0.5, 1.0}) {
    const Pose2 there = pose * Pose2::exp(share * kLeft.log());
    const LaserScan at_rest = laser.scan(office_scene(), there, Pose2(), random);
    const Time instant = laser.stamp + from_seconds(share * to_seconds(test::kRevolution));
    const auto after =
        test::range_differences(deskew(skewed, {kLeft, test::kRevolution}, instant), at_rest);
    EXPECT_GT(share_below(after, 0.002), 0.95) << share;
  }
}

// The laser turns by 0.125 rad: 29 of 1440 beams are missing at the seam, or twice there.
TEST(Deskew, TheSeamOpensOrOverlaps) {
  auto random = test::seeded_random();
  const test::MovingLaser laser = test::moving_laser(1440, 0.0);
  const auto valid = [&](double turn) {
    const Pose2 way(0.0, 0.0, turn);
    const LaserScan scan = deskew(laser.scan(test::room_with_pillar(), {}, way, random),
                                  {way, test::kRevolution}, laser.stamp);
    std::size_t count = 0;
    for (std::size_t i = 0; i < scan.size(); ++i) {
      count += scan.valid(i) ? 1U : 0U;
      if (!scan.valid(i)) {
        EXPECT_EQ(scan.status[i], BeamStatus::kErroneous);
      }
    }
    return count;
  };
  EXPECT_GE(valid(0.125), 1438U);
  EXPECT_NEAR(static_cast<double>(valid(-0.125)), 1440.0 * (1.0 - 0.125 / kTwoPi), 4.0);
}

TEST(Deskew, BeamsWithoutAReturnStayWithoutOne) {
  LaserScan scan = test::circle_of(std::vector<double>(360, test::kNoRange));
  scan.status.assign(360, BeamStatus::kNoReturn);
  scan.time_increment = test::kRevolution / 360;
  for (const Pose2& way : {kLeft, kRight, Pose2(0.3, 0.1, 0.0)}) {
    const LaserScan after = deskew(scan, {way, test::kRevolution}, scan.first_beam_time);
    std::size_t without = 0;
    for (std::size_t i = 0; i < 360; ++i) {
      EXPECT_FALSE(after.valid(i)) << i;
      without += after.status[i] == BeamStatus::kNoReturn ? 1U : 0U;
    }
    EXPECT_GE(without, way.theta() < 0.0 ? 351U : 359U);
  }
}

TEST(Deskew, APointAloneGoesToTheNearestBeam) {
  LaserScan scan = test::circle_of(std::vector<double>(360, test::kNoRange));
  scan.time_increment = test::kRevolution / 360;
  scan.ranges[270] = 2.0;
  scan.status[270] = BeamStatus::kValid;
  const LaserScan after = deskew(scan, {kLeft, test::kRevolution}, scan.first_beam_time);
  const Eigen::Vector2d moved = Pose2::exp(270.0 / 360.0 * kLeft.log()) * scan.point(270);
  std::size_t found = 0;
  for (std::size_t i = 0; i < 360; ++i) {
    if (!after.valid(i)) continue;
    ++found;
    EXPECT_NEAR(after.ranges[i], moved.norm(), 1e-6);
    EXPECT_LT(std::abs(angle_between(after.bearing(i), std::atan2(moved.y(), moved.x()))),
              0.5 * after.angle_increment + 1e-9);
  }
  EXPECT_EQ(found, 1U);
}

// A post before a wall hides what is behind it, also where it has moved to.
TEST(Deskew, TheNearestCountsWhereTheScanFolds) {
  std::vector<double> ranges(180, 4.0);
  for (std::size_t i = 80; i < 90; ++i) ranges[i] = 1.0;
  LaserScan scan = test::scan_of(ranges, -0.5 * kPi, kPi / 180.0);
  scan.intensities.assign(180, 1.0F);
  for (std::size_t i = 80; i < 90; ++i) scan.intensities[i] = 7.0F;
  scan.time_increment = test::kRevolution / 180;
  const Pose2 sideways(0.0, 0.8, 0.0);
  const LaserScan after = deskew(scan, {sideways, test::kRevolution}, scan.first_beam_time);
  std::size_t near = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (!after.valid(i) || after.ranges[i] > 2.0) continue;
    ++near;
    EXPECT_EQ(after.intensities[i], 7.0F);
    EXPECT_LT(after.ranges[i], 1.3);
  }
  EXPECT_GE(near, 8U);
  EXPECT_LE(near, 16U);
}

TEST(Deskew, KeepsToTheRangeOfTheLaser) {
  LaserScan scan = test::round_scan(99.99);
  scan.time_increment = test::kRevolution / 360;
  const LaserScan after =
      deskew(scan, {Pose2(0.5, 0.0, 0.0), test::kRevolution}, scan.first_beam_time);
  bool beyond = false;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (after.valid(i)) {
      EXPECT_LE(after.ranges[i], scan.range_max);
    }
    beyond = beyond || after.status[i] == BeamStatus::kTooFar;
  }
  EXPECT_TRUE(beyond);
}

}  // namespace
}  // namespace falko_slam
