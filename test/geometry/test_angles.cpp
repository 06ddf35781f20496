// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/angles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

TEST(WrapAngle, KeepsTheDirectionAndStaysInTheInterval) {
  auto random = test::seeded_random();
  for (int i = 0; i < 10000; ++i) {
    const double angle = test::uniform(random, -50.0, 50.0);
    const double wrapped = wrap_angle(angle);
    EXPECT_GE(wrapped, -kPi);
    EXPECT_LT(wrapped, kPi);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
  }
}

TEST(WrapAngle, TakesPiToMinusPi) {
  EXPECT_EQ(wrap_angle(kPi), -kPi);
  EXPECT_EQ(wrap_angle(-kPi), -kPi);
  EXPECT_NEAR(wrap_angle(3.0 * kPi), -kPi, 1e-15);
  EXPECT_EQ(wrap_angle(0.0), 0.0);
}

TEST(WrapAngle, StaysBelowPiNextToTheSeam) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double angle : {std::nextafter(-kPi, -infinity), std::nextafter(kPi, infinity),
                             std::nextafter(-3.0 * kPi, -infinity), -kPi - 1e-9, kPi - 1e-9}) {
    EXPECT_GE(wrap_angle(angle), -kPi) << angle;
    EXPECT_LT(wrap_angle(angle), kPi) << angle;
  }
}

TEST(AngleBetween, IsTheShortestTurn) {
  EXPECT_NEAR(angle_between(kPi - 0.1, -kPi + 0.1), 0.2, 1e-12);
  EXPECT_NEAR(angle_between(-kPi + 0.1, kPi - 0.1), -0.2, 1e-12);
  EXPECT_NEAR(angle_between(0.3, 0.3), 0.0, 1e-15);
}

TEST(ApproximateAtan2, IsNearTheExactOneAllAround) {
  double worst = 0.0;
  for (const double radius : {1e-9, 1.0, 1e9}) {
    for (int i = 0; i <= 100000; ++i) {
      const double angle = -kPi + kTwoPi * i / 100000;
      const double y = radius * std::sin(angle);
      const double x = radius * std::cos(angle);
      worst = std::max(worst, std::abs(approximate_atan2(y, x) - std::atan2(y, x)));
    }
  }
  EXPECT_LT(worst, 2e-5);
  EXPECT_EQ(approximate_atan2(0.0, 0.0), 0.0);
}

TEST(Degrees, ConvertBothWays) {
  EXPECT_DOUBLE_EQ(degrees_to_radians(180.0), kPi);
  EXPECT_DOUBLE_EQ(radians_to_degrees(kPi / 2.0), 90.0);
}

}  // namespace
}  // namespace falko_slam
