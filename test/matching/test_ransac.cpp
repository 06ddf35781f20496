// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/ransac.hpp"

#include <gtest/gtest.h>

#include "support/match_relations.hpp"

namespace falko_slam {
namespace {

using test::MatchPoints;

// Half of the points have a partner, and each match starts from the same random numbers.
test::Matcher ransac_matcher() {
  return [](const MatchPoints& source, const MatchPoints& target, const Pose2&) {
    RansacParams params;
    params.inlier_probability = 0.3;
    params.success_probability = 0.9999;
    auto random = test::seeded_random();
    return match_by_ransac(source, target, random, params);
  };
}

TEST(Ransac, FindsTheMotion) { test::expect_finds_the_motion(ransac_matcher(), 0); }

TEST(Ransac, FindsTheMotionAmongOutliers) { test::expect_finds_the_motion(ransac_matcher(), 6); }

TEST(Ransac, SwappedInputsGiveTheInverse) {
  test::expect_swapped_inputs_give_the_inverse(ransac_matcher());
}

TEST(Ransac, AMovedSourceComposes) { test::expect_moved_source_composes(ransac_matcher()); }

TEST(Ransac, TheOrderOfThePointsDoesNotMatter) {
  test::expect_order_does_not_matter(ransac_matcher());
}

TEST(Ransac, NoMirrorImageMatches) { test::expect_no_mirror_image_matches(ransac_matcher()); }

TEST(Ransac, SurvivesPoorInputs) { test::expect_poor_inputs_are_survived(ransac_matcher()); }

TEST(Ransac, RemembersNothing) { test::expect_no_memory_of_earlier_matches(ransac_matcher()); }

TEST(Ransac, DrawsUntilOneIsGoodWithTheProbabilityAskedFor) {
  RansacParams params;
  EXPECT_EQ(ransac_draws(params), 7);  // 0.51^6 = 0.018, 0.51^7 = 0.009
  params.inlier_probability = 0.1;
  EXPECT_EQ(ransac_draws(params), 459);
  params.success_probability = 0.0;
  EXPECT_EQ(ransac_draws(params), 0);
}

// 300 times seven draws from points of which 70 % have a partner.
TEST(Ransac, SucceedsAsOftenAsAskedFor) {
  auto random = test::seeded_random();
  int found = 0;
  for (int run = 0; run < 300; ++run) {
    MatchPoints source = test::random_match_points(14, 8.0, random);
    MatchPoints target = source;
    test::add_points(source, 6, 8.0, random);
    test::add_points(target, 6, 8.0, random);
    const Pose2 pose(1.0, 0.0, test::uniform(random, -kPi, kPi));
    found += match_by_ransac(source, test::moved(pose, target), random).pairs.size() >= 14;
  }
  EXPECT_GE(found, 291);  // 297 expected, three standard deviations less
}

TEST(Ransac, RepeatsWithTheSameRandomNumbers) {
  auto random = test::seeded_random();
  const test::TwoViews views = test::two_views({1.0, 1.0, 1.0}, 20, random);
  auto first_random = random;
  auto second_random = random;
  const MatchResult first = match_by_ransac(views.source, views.target, first_random);
  const MatchResult second = match_by_ransac(views.source, views.target, second_random);
  EXPECT_EQ(first.pairs, second.pairs);
  EXPECT_EQ(first_random, second_random);
}

TEST(Ransac, PairsOnlyWhatMayMatch) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 5.0, random);
  RansacParams params;
  params.success_probability = 0.9999;
  const MatchResult result =
      match_by_ransac(points, points, random, params,
                      [](std::size_t s, std::size_t t) { return s != 3 && t != 4; });
  EXPECT_EQ(result.pairs.size(), 6U);
}

TEST(Ransac, RefusesParametersOutOfRange) {
  RansacParams params;
  params.inlier_probability = 1.0;
  EXPECT_THROW(ransac_draws(params), std::invalid_argument);
  params = {};
  params.inlier_distance = -0.1;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
