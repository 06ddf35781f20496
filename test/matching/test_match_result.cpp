// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/match_result.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/match_relations.hpp"
#include "support/numbers.hpp"

namespace falko_slam {
namespace {

TEST(MatchPoint, IsUsableAtAPlaceThatIsAPlace) {
  EXPECT_TRUE((MatchPoint{{1e6, -1e6}, 0.0}.usable()));
  EXPECT_FALSE((MatchPoint{{test::kNaN, 0.0}, 0.0}.usable()));
  EXPECT_FALSE((MatchPoint{{0.0, test::kNaN}, 0.0}.usable()));
  EXPECT_FALSE((MatchPoint{{0.0, 2e6}, 0.0}.usable()));
}

TEST(MatchPoint, HasNoOrientationByDefault) {
  EXPECT_FALSE(MatchPoint().has_orientation());
  EXPECT_TRUE((MatchPoint{{0.0, 0.0}, 7.0}.has_orientation()));
}

TEST(MatchOf, SortsThePairsAndAlignsThem) {
  auto random = test::seeded_random();
  const test::MatchPoints points = test::random_match_points(3, 5.0, random);
  const Pose2 pose(1.0, 2.0, 0.5);
  const MatchResult result =
      match_of({{2, 2}, {0, 0}, {1, 1}}, points, test::moved(pose, points), 0.0);
  EXPECT_EQ(result.pairs, (std::vector<MatchPair>{{0, 0}, {1, 1}, {2, 2}}));
  ASSERT_TRUE(result.found());
  test::expect_near(result.target_T_source->pose, pose, 1e-12);
  EXPECT_LT(result.rms_residual, 1e-12);
  EXPECT_FALSE(result.proven);
}

TEST(MatchOf, TheCovarianceGrowsWithTheNoise) {
  auto random = test::seeded_random();
  const test::MatchPoints points = test::random_match_points(3, 5.0, random);
  const std::vector<MatchPair> pairs = {{0, 0}, {1, 1}, {2, 2}};
  const auto small = match_of(pairs, points, points, 0.01).target_T_source->covariance;
  const auto large = match_of(pairs, points, points, 0.02).target_T_source->covariance;
  EXPECT_LT((large - 4.0 * small).norm(), 1e-12);
}

TEST(MatchOf, RefusesPairsWithoutAHeading) {
  const test::MatchPoints same(2);
  const test::MatchPoints close = {{{0.0, 0.0}, test::kNaN}, {{1e-170, 0.0}, test::kNaN}};
  for (const auto& points : {same, close}) {
    const MatchResult result = match_of({{0, 0}, {1, 1}}, points, points, 0.03);
    EXPECT_FALSE(result.found());
    EXPECT_TRUE(result.pairs.empty());
  }
  EXPECT_FALSE(match_of({}, {}, {}, 0.03).found());
  EXPECT_FALSE(match_of({{0, 0}}, same, same, 0.03).found());
}

}  // namespace
}  // namespace falko_slam
