// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/nearest_neighbor.hpp"

#include <gtest/gtest.h>

#include "support/match_relations.hpp"

namespace falko_slam {
namespace {

using test::MatchPoints;

test::Matcher nearest_matcher() {
  return [](const MatchPoints& source, const MatchPoints& target, const Pose2& guess) {
    return match_nearest_neighbors(source, target, guess);
  };
}

TEST(NearestNeighbor, FindsTheMotion) { test::expect_finds_the_motion(nearest_matcher(), 0); }

TEST(NearestNeighbor, SwappedInputsGiveTheInverse) {
  test::expect_swapped_inputs_give_the_inverse(nearest_matcher());
}

TEST(NearestNeighbor, AMovedSourceComposes) {
  test::expect_moved_source_composes(nearest_matcher());
}

TEST(NearestNeighbor, TheOrderOfThePointsDoesNotMatter) {
  test::expect_order_does_not_matter(nearest_matcher());
}

TEST(NearestNeighbor, SurvivesPoorInputs) {
  test::expect_poor_inputs_are_survived(nearest_matcher());
}

TEST(NearestNeighbor, RemembersNothing) {
  test::expect_no_memory_of_earlier_matches(nearest_matcher());
}

TEST(NearestNeighbor, FindsTheMotionFromARoughOne) {
  auto random = test::seeded_random();
  for (const double heading : test::edge_headings()) {
    const test::TwoViews views = test::two_views({1.0, 2.0, heading}, 0, random);
    const Pose2 error(0.1, -0.1, 0.02);
    test::expect_common_pairs(
        match_nearest_neighbors(views.source, views.target, views.target_T_source * error), views);
  }
}

TEST(NearestNeighbor, PairsAreEachOthersNearest) {
  // The second source point is nearest to the target point that has a nearer one.
  const MatchPoints source = {{{0.0, 0.0}}, {{0.3, 0.0}}, {{3.0, 0.0}}};
  const MatchPoints target = {{{0.1, 0.0}}, {{3.0, 0.1}}};
  EXPECT_EQ(match_nearest_neighbors(source, target, Pose2()).pairs,
            (std::vector<MatchPair>{{0, 0}, {2, 1}}));
}

TEST(NearestNeighbor, TheDistanceItselfIsWithinReach) {
  const MatchPoints source = {{{0.0, 0.0}}, {{3.0, 0.0}}};
  EXPECT_TRUE(match_nearest_neighbors(source, {{{0.5, 0.0}}, {{3.5, 0.0}}}, Pose2()).found());
  EXPECT_FALSE(match_nearest_neighbors(source, {{{0.5, 0.0}}, {{3.51, 0.0}}}, Pose2()).found());
}

TEST(NearestNeighbor, OfEquallyNearOnesTheFirstCounts) {
  const MatchPoints source = {{{0.0, 0.0}}, {{3.0, 0.0}}};
  const MatchPoints target = {{{0.2, 0.0}}, {{-0.2, 0.0}}, {{3.0, 0.25}}, {{3.0, -0.25}}};
  EXPECT_EQ(match_nearest_neighbors(source, target, Pose2()).pairs,
            (std::vector<MatchPair>{{0, 0}, {1, 2}}));
}

TEST(NearestNeighbor, OrientationsChooseAmongNeighbors) {
  const MatchPoints source = {{{0.0, 0.0}, 0.0}, {{3.0, 0.0}, 0.0}};
  const MatchPoints target = {{{0.1, 0.0}, kPi}, {{0.2, 0.0}, 0.5}, {{3.0, 0.0}, 0.0}};
  EXPECT_EQ(match_nearest_neighbors(source, target, Pose2()).pairs,
            (std::vector<MatchPair>{{0, 1}, {1, 2}}));
}

TEST(NearestNeighbor, RefusesParametersOutOfRange) {
  NearestNeighborParams params;
  params.max_distance = 0.0;
  EXPECT_THROW(match_nearest_neighbors({}, {}, Pose2(), params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
