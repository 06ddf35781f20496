// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/glare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/random_points.hpp"

namespace falko_slam {
namespace {

using test::moved;
using test::random_points;

TEST(Glare, DoesNotDependOnTheOrderOfThePoints) {
  auto random = test::seeded_random();
  for (int i = 0; i < 100; ++i) {
    auto points = random_points(12, 10.0, random);
    const Signature before = glare(points);
    std::shuffle(points.begin(), points.end(), random);
    EXPECT_EQ(glare(points).cells, before.cells);
  }
}

TEST(Glare, DoesNotDependOnWhereThePointsAre) {
  auto random = test::seeded_random();
  const auto points = random_points(12, 10.0, random);
  // By powers of two: the differences stay the same to the last digit.
  EXPECT_EQ(glare(moved({1024.0, -512.0, 0.0}, points)).rows, 8);
  const ShiftedDistance found =
      shifted_distance(glare(points), glare(moved({100.0, -50.0, 0.0}, points)));
  EXPECT_EQ(found.distance, 0U);
  EXPECT_EQ(found.shift, 0);
}

TEST(Glare, TurnedByWholeCellsIsShifted) {
  auto random = test::seeded_random();
  for (int i = 0; i < 20; ++i) {
    const auto points = random_points(15, 9.0, random);
    for (int k = 0; k < 16; ++k) {
      const Pose2 turn(0.0, 0.0, k * kPi / 8.0);
      const ShiftedDistance found = shifted_distance(glare(points), glare(moved(turn, points)));
      EXPECT_EQ(found.distance, 0U);
      EXPECT_EQ(found.shift, k % 8);
    }
  }
}

TEST(Glare, AnyTurnIsNearerThanAnotherPlace) {
  auto random = test::seeded_random();
  for (int i = 0; i < 50; ++i) {
    const auto points = random_points(12, 9.0, random);
    const Pose2 turn(0.0, 0.0, test::uniform(random, -kPi, kPi));
    const auto same = shifted_distance(glare(points), glare(moved(turn, points))).distance;
    const auto other =
        shifted_distance(glare(points), glare(random_points(12, 9.0, random))).distance;
    EXPECT_LT(same, other);
  }
}

TEST(Glare, HasTheSameSumForAnyNumberOfPoints) {
  auto random = test::seeded_random();
  for (const std::size_t count : {10U, 20U, 40U}) {
    const Signature signature = glare(random_points(count, 6.0, random));
    const int sum = std::accumulate(signature.cells.begin(), signature.cells.end(), 0);
    EXPECT_NEAR(sum, 4096, 60);  // 400 cells, each rounded
  }
}

TEST(Glare, PutsAPairWhereItBelongs) {
  // Direction 34 degrees: cell 1 of 22.5; distance 1.11 m: cell 5 of 0.2. Nothing two cells away.
  const double angle = 34.0 * kPi / 180.0;
  const Signature signature = glare({{0.0, 0.0}, {1.11 * std::cos(angle), 1.11 * std::sin(angle)}});
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 50; ++column) {
      const bool near = row <= 2 && column >= 4 && column <= 6;
      EXPECT_EQ(signature.at(row, column) > 0, near) << row << ", " << column;
    }
  }
}

TEST(Glare, DirectionsWrapAround) {
  // Just below 180 degrees: spread over the last row and the first.
  const Signature signature = glare({{0.0, 0.0}, {-1.1, 0.01}});
  EXPECT_GT(signature.at(7, 5), 0);
  EXPECT_GT(signature.at(0, 5), 0);
  EXPECT_EQ(signature.at(3, 5), 0);
}

TEST(Glare, IsEmptyWithoutAPair) {
  EXPECT_TRUE(glare({}).empty());
  EXPECT_TRUE(glare({{1.0, 2.0}}).empty());
  EXPECT_TRUE(glare({{0.0, 0.0}, {11.0, 0.0}}).empty());  // beyond 50 cells of 0.2 m
}

TEST(Glare, SurvivesPointsInOnePlace) {
  const Signature signature = glare({{1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}});
  EXPECT_GT(signature.at(0, 0), 0);
}

TEST(GlareParams, NamesFieldAndValueOfWhatIsWrong) {
  GlareParams params;
  params.direction_cells = 1;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "direction_cells = 1: must be in [2, 64]");
  }
}

}  // namespace
}  // namespace falko_slam
