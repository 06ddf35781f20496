// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/gsr.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "support/point_sets.hpp"

namespace falko_slam {
namespace {

using test::MatchPoints;
using test::moved;
using test::random_match_points;

// Of two signatures whose pairs differ by rounding: a cell or two may be off by one.
constexpr std::uint32_t kRounding = 4;

TEST(Gsr, DoesNotDependOnWhereThePointsAreAndHowTheyAreTurned) {
  auto random = test::seeded_random();
  for (const double heading : test::edge_headings()) {
    const MatchPoints points = random_match_points(15, 4.0, random);
    const Pose2 pose(test::uniform(random, -20.0, 20.0), test::uniform(random, -20.0, 20.0),
                     heading);
    EXPECT_LE(l1_distance(gsr(points), gsr(moved(pose, points))), kRounding) << heading;
  }
}

TEST(Gsr, DoesNotDependOnTheOrderOfThePoints) {
  auto random = test::seeded_random();
  for (int i = 0; i < 50; ++i) {
    MatchPoints points = random_match_points(12, 4.0, random);
    const Signature before = gsr(points);
    std::shuffle(points.begin(), points.end(), random);
    EXPECT_EQ(l1_distance(gsr(points), before), 0U);
  }
}

TEST(Gsr, IsTheSameForAMirrorImage) {
  auto random = test::seeded_random();
  const MatchPoints points = random_match_points(12, 4.0, random);
  EXPECT_LE(l1_distance(gsr(points), gsr(test::mirrored(points))), kRounding);
}

TEST(Gsr, HasASymmetricDistanceThatTellsOtherPlacesApart) {
  auto random = test::seeded_random();
  for (int i = 0; i < 50; ++i) {
    const MatchPoints points = random_match_points(12, 4.0, random);
    const Signature here = gsr(points);
    const Signature again = gsr(test::shaken(points, 0.02, random));
    const Signature elsewhere = gsr(random_match_points(12, 4.0, random));
    EXPECT_EQ(l1_distance(here, elsewhere), l1_distance(elsewhere, here));
    EXPECT_LT(l1_distance(here, again), l1_distance(here, elsewhere));
  }
}

TEST(Gsr, PutsAPairWhereItBelongs) {
  // 1.1 m apart: the middle of cell 5; normals 34 degrees apart, on both sides of pi: cell 1.
  const double half = degrees_to_radians(17.0);
  const Signature signature =
      gsr({{{0.0, 0.0}, kPi - half}, {{0.0, 1.1}, half - kPi}, {{50.0, 0.0}, 0.0}});
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 50; ++column) {
      const bool near = row <= 2 && column >= 4 && column <= 6;
      EXPECT_EQ(signature.at(row, column) > 0, near) << row << ", " << column;
    }
  }
}

TEST(Gsr, KeepsParallelAndOppositeNormalsApart) {
  const Signature parallel = gsr({{{0.0, 0.0}, 0.3}, {{1.1, 0.0}, 0.3}});
  const Signature opposite = gsr({{{0.0, 0.0}, 0.3}, {{1.1, 0.0}, 0.3 + kPi}});
  for (int row = 0; row < 8; ++row) {
    EXPECT_EQ(parallel.at(row, 5) > 0, row <= 1) << row;
    EXPECT_EQ(opposite.at(row, 5) > 0, row >= 6) << row;
  }
}

TEST(Gsr, HasTheSameSumForAnyNumberOfPoints) {
  auto random = test::seeded_random();
  for (const std::size_t count : {10U, 20U, 40U}) {
    const Signature signature = gsr(random_match_points(count, 4.0, random));
    EXPECT_NEAR(std::accumulate(signature.cells.begin(), signature.cells.end(), 0), 4096, 60);
  }
}

TEST(Gsr, IsEmptyWithoutAPair) {
  EXPECT_TRUE(gsr({}).empty());
  EXPECT_TRUE(gsr({{{1.0, 2.0}, 0.0}}).empty());
  EXPECT_TRUE(gsr({{{0.0, 0.0}, 0.0}, {{11.0, 0.0}, 0.0}}).empty());  // beyond 50 cells of 0.2 m
}

TEST(Gsr, LeavesOutPointsWithoutANormalOrAPlace) {
  auto random = test::seeded_random();
  const MatchPoints points = random_match_points(10, 4.0, random);
  MatchPoints more = points;
  more.push_back({{0.1, 0.2}});
  more.push_back({{std::nan(""), 0.0}, 1.0});
  EXPECT_EQ(gsr(more).cells, gsr(points).cells);
  EXPECT_TRUE(gsr(test::without_orientation(points)).empty());
}

TEST(GsrParams, NamesFieldAndValueOfWhatIsWrong) {
  GsrParams params;
  params.angle_cells = 1;
  try {
    gsr({}, params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "angle_cells = 1: must be in [2, 64]");
  }
}

}  // namespace
}  // namespace falko_slam
