// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/two_point_matcher.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/match_relations.hpp"

namespace falko_slam {
namespace {

using test::MatchPoints;

// The best match.
test::Matcher two_point_matcher() {
  auto matcher = std::make_shared<TwoPointMatcher>();
  return [=](const MatchPoints& source, const MatchPoints& target, const Pose2&) {
    const auto matches = matcher->match(source, target);
    return matches.empty() ? MatchResult() : matches.front();
  };
}

TEST(TwoPointMatcher, FindsTheMotion) { test::expect_finds_the_motion(two_point_matcher(), 0); }

TEST(TwoPointMatcher, FindsTheMotionAmongOutliers) {
  test::expect_finds_the_motion(two_point_matcher(), 6);
}

TEST(TwoPointMatcher, SwappedInputsGiveTheInverse) {
  test::expect_swapped_inputs_give_the_inverse(two_point_matcher());
}

TEST(TwoPointMatcher, AMovedSourceComposes) {
  test::expect_moved_source_composes(two_point_matcher());
}

TEST(TwoPointMatcher, TheOrderOfThePointsDoesNotMatter) {
  test::expect_order_does_not_matter(two_point_matcher());
}

TEST(TwoPointMatcher, NoMirrorImageMatches) {
  test::expect_no_mirror_image_matches(two_point_matcher());
}

TEST(TwoPointMatcher, SurvivesPoorInputs) {
  test::expect_poor_inputs_are_survived(two_point_matcher());
}

TEST(TwoPointMatcher, RemembersNothing) {
  test::expect_no_memory_of_earlier_matches(two_point_matcher());
}

// All hypotheses of all segments, each with its exact number of pairs.
std::size_t most_pairs(const MatchPoints& source, const MatchPoints& target) {
  std::size_t most = 0;
  for (std::size_t a = 0; a < source.size(); ++a) {
    for (std::size_t b = 0; b < source.size(); ++b) {
      for (std::size_t c = 0; c < target.size(); ++c) {
        for (std::size_t d = 0; d < target.size(); ++d) {
          if (a == b || c == d) continue;
          const MatchResult two = match_of({{a, c}, {b, d}}, source, target, 0.03);
          if (!two.found() || two.rms_residual > 0.03) continue;
          std::size_t pairs = 0;
          for (const MatchPoint& p : source) {
            const Eigen::Vector2d q = two.target_T_source->pose * p.position;
            pairs += std::any_of(target.begin(), target.end(), [&](const MatchPoint& t) {
              return (t.position - q).norm() <= 0.05;
            });
          }
          most = std::max(most, pairs);
        }
      }
    }
  }
  return most;
}

TEST(TwoPointMatcher, FindsNoFewerPairsThanTryingAllMotions) {
  auto random = test::seeded_random();
  for (int run = 0; run < 20; ++run) {
    const test::TwoViews views =
        test::two_views({1.0, 2.0, test::uniform(random, -kPi, kPi)}, 3, random);
    const MatchPoints source = test::without_orientation(views.source);
    const auto matches = TwoPointMatcher().match(source, views.target);
    ASSERT_FALSE(matches.empty());
    EXPECT_GE(matches[0].pairs.size(), most_pairs(source, views.target));
  }
}

// A room that looks the same from two sides.
TEST(TwoPointMatcher, ReturnsBothWaysToMatchASymmetricRoom) {
  const MatchPoints room = {{{-3.0, -2.0}}, {{3.0, 2.0}}, {{-3.0, 2.0}}, {{3.0, -2.0}}};
  const auto matches = TwoPointMatcher().match(room, room);
  ASSERT_GE(matches.size(), 2U);
  EXPECT_EQ(matches[0].pairs.size(), 4U);
  EXPECT_EQ(matches[1].pairs.size(), 4U);
  EXPECT_NEAR(std::abs(angle_between(matches[0].target_T_source->pose.theta(),
                                     matches[1].target_T_source->pose.theta())),
              kPi, 1e-9);
}

TEST(TwoPointMatcher, MatchesAreApartAndTheBestComesFirst) {
  auto random = test::seeded_random();
  TwoPointMatcherParams params;
  params.max_matches = 5;
  for (int run = 0; run < 20; ++run) {
    const auto matches = TwoPointMatcher(params).match(test::random_match_points(20, 4.0, random),
                                                       test::random_match_points(20, 4.0, random));
    EXPECT_LE(matches.size(), 5U);
    for (std::size_t i = 0; i < matches.size(); ++i) {
      EXPECT_GE(matches[i].pairs.size(), 3U);
      for (std::size_t j = i + 1; j < matches.size(); ++j) {
        EXPECT_GE(matches[i].pairs.size(), matches[j].pairs.size());
        const Pose2& a = matches[i].target_T_source->pose;
        const Pose2& b = matches[j].target_T_source->pose;
        EXPECT_TRUE((a.translation() - b.translation()).norm() > params.separation ||
                    std::abs(angle_between(a.theta(), b.theta())) > params.heading_separation);
      }
    }
  }
}

// 60 of 780 segments are asked, and still every point takes part.
TEST(TwoPointMatcher, FindsManyPointsFromFewSegments) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(40, 10.0, random);
  const auto matches = TwoPointMatcher().match(points, test::moved({1.0, 1.0, 3.0}, points));
  ASSERT_FALSE(matches.empty());
  EXPECT_EQ(matches[0].pairs.size(), 40U);
}

TEST(TwoPointMatcher, AsksOrientationsToConfirmTheHeading) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 5.0, random);
  MatchPoints turned = points;
  turned[2].orientation += kPi;
  const auto matches = TwoPointMatcher().match(points, turned);
  ASSERT_FALSE(matches.empty());
  EXPECT_EQ(matches[0].pairs.size(), 7U);
}

TEST(TwoPointMatcher, PairsOnlyWhatMayMatch) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 5.0, random);
  const auto matches = TwoPointMatcher().match(
      points, points, [](std::size_t s, std::size_t t) { return s != 3 && t != 4; });
  ASSERT_FALSE(matches.empty());
  EXPECT_EQ(matches[0].pairs.size(), 6U);
}

TEST(TwoPointMatcher, RefusesParametersOutOfRange) {
  TwoPointMatcherParams params;
  params.max_matches = 0;
  EXPECT_THROW(TwoPointMatcher{params}, std::invalid_argument);
  params = {};
  params.inlier_distance = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
