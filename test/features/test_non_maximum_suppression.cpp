// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "non_maximum_suppression.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

CornerCandidate candidate(double x, double y, float rank, std::size_t beam) {
  CornerCandidate result{};
  result.position = {x, y};
  result.rank = rank;
  result.roughness_square = static_cast<double>(rank);
  result.beam = beam;
  return result;
}

TEST(NonMaximumSuppression, KeepsTheBestOfNeighbors) {
  NonMaximumSuppression suppress;
  const auto& kept = suppress(
      {candidate(0.0, 0.0, 0.5F, 1), candidate(0.15, 0.0, 0.2F, 2), candidate(1.0, 0.0, 0.9F, 3)},
      0.2, 0.0);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].index, 1U);
  EXPECT_EQ(kept[1].index, 2U);
}

TEST(NonMaximumSuppression, WhatIsSuppressedSuppressesNothing) {
  NonMaximumSuppression suppress;
  const auto& kept = suppress(
      {candidate(0.0, 0.0, 0.1F, 1), candidate(0.15, 0.0, 0.2F, 2), candidate(0.30, 0.0, 0.3F, 3)},
      0.2, 0.0);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].index, 0U);
  EXPECT_EQ(kept[1].index, 2U);
}

TEST(NonMaximumSuppression, MergesByWeight) {
  NonMaximumSuppression suppress;
  // Squared roughness 0.01 and 0.04: weights 4 to 1.
  const auto& kept =
      suppress({candidate(0.0, 0.0, 0.01F, 1), candidate(0.05, 0.0, 0.04F, 2)}, 0.2, 0.1);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_NEAR(kept[0].position.x(), 0.05 / 5.0, 1e-5);
}

TEST(NonMaximumSuppression, WithoutMergeRadiusPositionsStay) {
  NonMaximumSuppression suppress;
  const auto& kept =
      suppress({candidate(0.0, 0.0, 0.01F, 1), candidate(0.05, 0.0, 0.04F, 2)}, 0.2, 0.0);
  EXPECT_EQ(kept[0].position.x(), 0.0);
}

// Of candidates with the same rank the choice must not depend on their numbers.
TEST(NonMaximumSuppression, BreaksTiesByWhatTurnsWithTheScan) {
  NonMaximumSuppression suppress;
  CornerCandidate near = candidate(0.0, 0.0, 0.5F, 7);
  near.range = 1.0;
  CornerCandidate far = candidate(0.1, 0.0, 0.5F, 2);
  far.range = 2.0;
  for (const auto& order :
       {std::vector<CornerCandidate>{near, far}, std::vector<CornerCandidate>{far, near}}) {
    const auto& kept = suppress(order, 0.2, 0.0);
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_EQ(order[kept[0].index].range, 1.0);
  }
}

// Every candidate is within reach of a better kept one, and no two kept ones are within reach.
TEST(NonMaximumSuppression, IsGreedy) {
  auto random = test::seeded_random();
  NonMaximumSuppression suppress;
  constexpr double kRadius = 0.2;
  for (int run = 0; run < 50; ++run) {
    std::vector<CornerCandidate> candidates;
    for (std::size_t i = 0; i < 100; ++i) {
      candidates.push_back(candidate(test::uniform(random, 0.0, 2.0),
                                     test::uniform(random, 0.0, 2.0),
                                     static_cast<float>(test::uniform(random, 0.0, 1.0)), i));
    }
    const auto& kept = suppress(candidates, kRadius, 0.0);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [&](const KeptCorner& k) {
        const CornerCandidate& other = candidates[k.index];
        return other.rank <= candidates[i].rank &&
               (other.position - candidates[i].position).norm() <= kRadius;
      }));
    }
    for (const KeptCorner& a : kept) {
      for (const KeptCorner& b : kept) {
        EXPECT_TRUE(a.index == b.index || (a.position - b.position).norm() > kRadius);
      }
    }
  }
}

}  // namespace
}  // namespace falko_slam
