// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/point_association.hpp"

#include <gtest/gtest.h>

#include <set>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;
using PairSet = std::set<std::pair<std::size_t, std::size_t>>;

PairSet as_set(const std::vector<AssociatedPair>& pairs) {
  PairSet set;
  for (const auto& pair : pairs) set.insert({pair.first, pair.second});
  return set;
}

Points random_points(std::mt19937_64& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(test::uniform(random, 0.0, 2.0), test::uniform(random, 0.0, 2.0));
  }
  return points;
}

// The definition, word for word: look for the nearest pair of what is left, again and again.
PairSet associate_naively(const Points& first, const Points& second, double radius) {
  std::set<std::size_t> taken_first;
  std::set<std::size_t> taken_second;
  PairSet pairs;
  for (;;) {
    double nearest = radius;
    std::pair<std::size_t, std::size_t> best;
    bool found = false;
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (std::size_t j = 0; j < second.size(); ++j) {
        const double distance = (first[i] - second[j]).norm();
        if (taken_first.count(i) + taken_second.count(j) > 0 || distance > nearest) continue;
        nearest = distance;
        best = {i, j};
        found = true;
      }
    }
    if (!found) return pairs;
    pairs.insert(best);
    taken_first.insert(best.first);
    taken_second.insert(best.second);
  }
}

TEST(AssociateGreedily, TakesTheNearestPairFirst) {
  // The point at 0.6 is within reach of both, and nearer to the second.
  const Points first = {{0.0, 0.0}, {1.0, 0.0}};
  EXPECT_EQ(as_set(associate_greedily(first, {{0.6, 0.0}}, 1.0)), (PairSet{{1, 0}}));
}

TEST(AssociateGreedily, PairsWhatIsLeft) {
  const Points first = {{0.0, 0.0}, {1.0, 0.0}};
  const Points second = {{0.6, 0.0}, {1.7, 0.0}};
  EXPECT_EQ(as_set(associate_greedily(first, second, 1.0)), (PairSet{{1, 0}}));
  EXPECT_EQ(as_set(associate_greedily(first, second, 2.0)), (PairSet{{1, 0}, {0, 1}}));
}

TEST(AssociateGreedily, TheRadiusItselfIsWithinReach) {
  EXPECT_EQ(associate_greedily({{0.0, 0.0}}, {{0.5, 0.0}}, 0.5).size(), 1U);
  EXPECT_EQ(associate_greedily({{0.0, 0.0}}, {{0.51, 0.0}}, 0.5).size(), 0U);
}

TEST(AssociateGreedily, NothingPairsWithNothing) {
  EXPECT_TRUE(associate_greedily({}, {{0.0, 0.0}}, 1.0).empty());
  EXPECT_TRUE(associate_greedily({{0.0, 0.0}}, {}, 1.0).empty());
}

TEST(AssociateGreedily, DoesAsItsDefinitionSays) {
  auto random = test::seeded_random();
  for (int run = 0; run < 30; ++run) {
    const Points first = random_points(random, 25);
    const Points second = random_points(random, 20);
    EXPECT_EQ(as_set(associate_greedily(first, second, 0.3)),
              associate_naively(first, second, 0.3));
  }
}

TEST(AssociateGreedily, SwappedSidesGiveTheSamePairs) {
  auto random = test::seeded_random();
  for (int run = 0; run < 30; ++run) {
    const Points first = random_points(random, 40);
    const Points second = random_points(random, 30);
    PairSet swapped;
    for (const auto& pair : associate_greedily(second, first, 0.3)) {
      swapped.insert({pair.second, pair.first});
    }
    EXPECT_EQ(as_set(associate_greedily(first, second, 0.3)), swapped);
  }
}

TEST(Positions, AreInTheMap) {
  Keypoint keypoint;
  keypoint.position = {1.0, 0.0};
  EXPECT_EQ(positions({keypoint}).at(0), Eigen::Vector2d(1.0, 0.0));
  EXPECT_LT((positions({keypoint}, {2.0, 3.0, kPi / 2.0}).at(0) - Eigen::Vector2d(2.0, 4.0)).norm(),
            1e-12);
}

TEST(Repeatability, IsTheShareOfTheSmallerSet) {
  const Points three = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  EXPECT_EQ(repeatability(three, {{0.05, 0.0}, {5.0, 0.0}}, 0.1), 0.5);
  EXPECT_EQ(repeatability({{0.05, 0.0}, {5.0, 0.0}}, three, 0.1), 0.5);
  EXPECT_EQ(repeatability(three, three, 0.1), 1.0);
}

TEST(Repeatability, IsZeroWhereNothingWasFoundAgain) {
  EXPECT_EQ(repeatability({{0.0, 0.0}}, {}, 0.1), 0.0);
}

}  // namespace
}  // namespace falko_slam
