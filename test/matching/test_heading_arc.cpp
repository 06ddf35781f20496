// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "heading_arc.hpp"

#include <gtest/gtest.h>

#include "support/point_sets.hpp"

namespace falko_slam {
namespace {

constexpr BinaryAngle kQuarterTurn = BinaryAngle{1} << 30;

TEST(BinaryAngle, WrapsByItself) {
  EXPECT_EQ(binary_angle(0.0), 0U);
  EXPECT_EQ(binary_angle(0.5 * kPi), kQuarterTurn);
  EXPECT_EQ(binary_angle(-0.5 * kPi), 3 * kQuarterTurn);
  EXPECT_EQ(binary_angle(kPi), binary_angle(-kPi));
  EXPECT_EQ(binary_angle(3.0 * kPi), binary_angle(kPi));
}

TEST(BinaryAngle, KeepsDifferences) {
  for (const double a : test::edge_headings()) {
    for (const double b : test::edge_headings()) {
      const auto difference = static_cast<std::int32_t>(binary_angle(b) - binary_angle(a));
      const double radians = difference / kBinaryTurn * kTwoPi;
      EXPECT_NEAR(angle_between(radians, angle_between(a, b)), 0.0, 4e-9);
    }
  }
}

bool contains(const HeadingArc& arc, BinaryAngle heading) {
  return heading - arc.begin <= arc.extent;
}

// Where membership can change: at the ends of the arcs.
TEST(HeadingArc, IntersectionIsWhatBothContain) {
  auto random = test::seeded_random();
  std::uniform_int_distribution<BinaryAngle> any;
  std::uniform_int_distribution<BinaryAngle> less_than_half(0, 2 * kQuarterTurn - 1);
  for (int run = 0; run < 1000; ++run) {
    const HeadingArc a{any(random), less_than_half(random)};
    const HeadingArc b{any(random), less_than_half(random) >> (run % 32)};
    const auto both = intersection(a, b);
    for (const HeadingArc& arc : {a, b}) {
      for (const BinaryAngle end : {arc.begin, arc.begin + arc.extent}) {
        for (const BinaryAngle heading : {end - 1, end, end + 1}) {
          const bool expected = contains(a, heading) && contains(b, heading);
          EXPECT_EQ(both && contains(*both, heading), expected);
        }
      }
    }
  }
}

TEST(HeadingArc, TheFullOneLeavesTheOtherAsItIs) {
  const HeadingArc arc{5, 7};
  for (const auto& both : {intersection(arc, {}), intersection({}, arc)}) {
    ASSERT_TRUE(both);
    EXPECT_EQ(both->begin, 5U);
    EXPECT_EQ(both->extent, 7U);
  }
  EXPECT_TRUE(intersection({}, {})->full());
}

TEST(HeadingArc, EndsBelongToIt) {
  EXPECT_TRUE(intersection(arc_around(0, 10), {10, 5}));
  EXPECT_FALSE(intersection(arc_around(0, 10), {11, 5}));
  EXPECT_TRUE(intersection(arc_around(0, 10), {0U - 20U, 10}));
}

}  // namespace
}  // namespace falko_slam
