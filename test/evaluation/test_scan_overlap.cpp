// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/scan_overlap.hpp"

#include <gtest/gtest.h>

#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// Of the areas below with cells of this size: their edges of about 2 pi r / cell cells are counted
// to within a fraction of a cell each.
constexpr double kCell = 0.02;
constexpr double kCountingError = 0.01;

PosedScan office_scan(const Pose2& pose) {
  auto random = test::seeded_random();
  return {test::closed_scan(office_scene(), pose, 720, 0.0, random), pose};
}

TEST(ScanOverlap, OfAScanWithItselfIsOne) {
  const PosedScan scan = office_scan({-3.0, -1.0, 0.7});
  EXPECT_EQ(scan_overlap(scan, scan), 1.0);
}

TEST(ScanOverlap, OfOneCircleInAnotherIsTheRatioOfTheirAreas) {
  const PosedScan small{test::round_scan(1.0), {}};
  const PosedScan large{test::round_scan(2.0), {}};
  EXPECT_NEAR(scan_overlap(small, large, kCell), 0.25, kCountingError);
  EXPECT_NEAR(scan_overlap(large, small, kCell), 0.25, kCountingError);
}

TEST(ScanOverlap, OfTwoEqualCirclesIsThatOfTheirLens) {
  const PosedScan left{test::round_scan(1.0), {}};
  for (const double apart : {0.5, 1.0, 1.9}) {
    const PosedScan right{test::round_scan(1.0), {apart, 0.0, 2.0}};
    const double lens = 2.0 * std::acos(0.5 * apart) - 0.5 * apart * std::sqrt(4.0 - apart * apart);
    EXPECT_NEAR(scan_overlap(left, right, kCell), lens / (kTwoPi - lens), kCountingError) << apart;
  }
}

TEST(ScanOverlap, OfScansOutOfSightIsZero) {
  const PosedScan here{test::round_scan(1.0), {}};
  const PosedScan there{test::round_scan(1.0), {2.5, 0.0, 0.0}};
  EXPECT_EQ(scan_overlap(here, there), 0.0);
}

TEST(ScanOverlap, OfTwoHalvesBackToBackIsNearlyZero) {
  const LaserScan half = test::scan_of(std::vector<double>(180, 1.0), -kPi / 2.0, kPi / 180.0);
  // They share the row of cells along their common edge, of 2 / cell cells.
  const double edge = 2.0 / kCell / (kPi / (kCell * kCell));
  EXPECT_LT(scan_overlap({half, {}}, {half, {0.0, 0.0, kPi}}, kCell), 1.5 * edge);
}

TEST(ScanOverlap, InvalidBeamsSeeNothing) {
  LaserScan half = test::round_scan(1.0);
  for (std::size_t i = 0; i < half.size() / 2; ++i) half.status[i] = BeamStatus::kNoReturn;
  EXPECT_NEAR(scan_overlap({half, {}}, {test::round_scan(1.0), {}}, kCell), 0.5, kCountingError);
}

TEST(ScanOverlap, IsZeroWhereNothingIsSeenFree) {
  const PosedScan blind{test::circle_of(std::vector<double>(360, test::kNoRange)), {}};
  EXPECT_EQ(scan_overlap(blind, blind), 0.0);
}

TEST(ScanOverlap, EndsAtTheMaximumRange) {
  // Within 1 m of the first scan both see everything, beyond it they differ.
  const PosedScan near{test::round_scan(2.0), {}};
  const PosedScan far{test::round_scan(8.0), {}};
  EXPECT_EQ(scan_overlap(near, far, 0.1, 1.0), 1.0);
}

TEST(ScanOverlap, DoesNotDependOnTheMapFrame) {
  const Pose2 a(-3.0, -1.0, 0.7);
  const Pose2 b(-2.0, -0.8, -1.0);
  const double overlap = scan_overlap(office_scan(a), office_scan(b));
  const Pose2 motion(50.0, -20.0, 2.5);
  PosedScan moved_a = office_scan(a);
  PosedScan moved_b = office_scan(b);
  moved_a.map_T_laser = motion * a;
  moved_b.map_T_laser = motion * b;
  EXPECT_GT(overlap, 0.2);
  EXPECT_LT(overlap, 0.95);
  EXPECT_NEAR(scan_overlap(moved_a, moved_b), overlap, 1e-3);
}

}  // namespace
}  // namespace falko_slam
