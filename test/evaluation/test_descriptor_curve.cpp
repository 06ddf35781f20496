// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/descriptor_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

const std::vector<DescriptorPair> kFivePairs = {
    {1.0, true}, {2.0, false}, {3.0, true}, {4.0, false}, {5.0, true}};

void expect_curve(const std::vector<PrecisionRecall>& curve,
                  const std::vector<PrecisionRecall>& expected) {
  ASSERT_EQ(curve.size(), expected.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_EQ(curve[i].threshold, expected[i].threshold) << i;
    EXPECT_NEAR(curve[i].precision, expected[i].precision, 1e-12) << i;
    EXPECT_NEAR(curve[i].recall, expected[i].recall, 1e-12) << i;
  }
}

std::vector<DescriptorPair> random_pairs(std::mt19937_64& random, int count) {
  std::vector<DescriptorPair> pairs;
  for (int i = 0; i < count; ++i) {
    // Whole numbers, so that many distances are the same.
    pairs.push_back(
        {std::floor(test::uniform(random, 0.0, 60.0)), test::uniform(random, 0.0, 1.0) < 0.2});
  }
  return pairs;
}

TEST(PrecisionRecallCurve, CountsByHand) {
  expect_curve(precision_recall_curve(kFivePairs, 3),
               {{1.0, 1.0, 1.0 / 3.0}, {3.0, 2.0 / 3.0, 2.0 / 3.0}, {5.0, 3.0 / 5.0, 1.0}});
}

TEST(PrecisionRecallCurve, DoesNotDependOnTheOrderOfThePairs) {
  auto random = test::seeded_random();
  const auto curve = precision_recall_curve(kFivePairs, 3);
  for (int run = 0; run < 10; ++run) {
    auto pairs = kFivePairs;
    std::shuffle(pairs.begin(), pairs.end(), random);
    expect_curve(precision_recall_curve(pairs, 3), curve);
  }
}

TEST(PrecisionRecallCurve, TakesPairsOfOneDistanceTogether) {
  expect_curve(precision_recall_curve({{1.0, true}, {1.0, false}, {1.0, false}, {2.0, true}}, 10),
               {{1.0, 1.0 / 3.0, 0.5}, {2.0, 0.5, 1.0}});
}

TEST(PrecisionRecallCurve, EveryPointStatesWhatItsThresholdTakes) {
  auto random = test::seeded_random();
  for (const std::size_t points : {1U, 7U, 50U, 1000U}) {
    const auto pairs = random_pairs(random, 400);
    const auto curve = precision_recall_curve(pairs, points);
    ASSERT_FALSE(curve.empty());
    EXPECT_LE(curve.size(), points);
    double all_same = 0.0;
    for (const auto& pair : pairs) all_same += pair.same_point ? 1.0 : 0.0;
    for (const auto& point : curve) {
      double taken = 0.0;
      double same = 0.0;
      for (const auto& pair : pairs) {
        if (pair.distance > point.threshold) continue;
        taken += 1.0;
        same += pair.same_point ? 1.0 : 0.0;
      }
      EXPECT_NEAR(point.precision, same / taken, 1e-12);
      EXPECT_NEAR(point.recall, same / all_same, 1e-12);
    }
  }
}

TEST(PrecisionRecallCurve, AscendsToTheLastSamePoint) {
  auto random = test::seeded_random();
  const auto curve = precision_recall_curve(random_pairs(random, 400), 20);
  EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end(), [](const auto& a, const auto& b) {
    return a.threshold < b.threshold;
  }));
  EXPECT_EQ(curve.back().recall, 1.0);
}

TEST(PrecisionRecallCurve, IsEmptyWithoutTheSamePoint) {
  EXPECT_TRUE(precision_recall_curve({}, 10).empty());
  EXPECT_TRUE(precision_recall_curve({{1.0, false}, {2.0, false}}, 10).empty());
  EXPECT_TRUE(precision_recall_curve(kFivePairs, 0).empty());
}

TEST(RecallAt, TakesTheBestPointThatIsPureEnough) {
  const std::vector<PrecisionRecall> curve = {{1.0, 1.0, 0.2}, {2.0, 0.5, 0.4}, {3.0, 0.75, 0.6}};
  EXPECT_EQ(recall_at(curve, 0.0), 0.2);
  EXPECT_EQ(recall_at(curve, 0.25), 0.6);
  EXPECT_EQ(recall_at(curve, 0.9), 0.6);
}

TEST(RecallAt, IsZeroWhereNothingIsPureEnough) {
  EXPECT_EQ(recall_at({{1.0, 0.5, 0.4}}, 0.1), 0.0);
  EXPECT_EQ(recall_at({}, 1.0), 0.0);
}

}  // namespace
}  // namespace falko_slam
