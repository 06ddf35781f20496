// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/affine_hough.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "support/match_relations.hpp"

namespace falko_slam {
namespace {

using test::MatchPoints;

// Of the points: half a heading step moves none of them by more than a cell.
constexpr double kHalfWidth = 2.5;

test::Matcher hough_matcher() {
  auto matcher = std::make_shared<AffineHoughMatcher>();
  return [=](const MatchPoints& source, const MatchPoints& target, const Pose2&) {
    return matcher->match(source, target);
  };
}

TEST(AffineHough, FindsTheMotion) { test::expect_finds_the_motion(hough_matcher(), 0, kHalfWidth); }

TEST(AffineHough, FindsTheMotionAmongOutliers) {
  test::expect_finds_the_motion(hough_matcher(), 6, kHalfWidth);
}

TEST(AffineHough, SwappedInputsGiveTheInverse) {
  test::expect_swapped_inputs_give_the_inverse(hough_matcher(), kHalfWidth);
}

TEST(AffineHough, AMovedSourceComposes) {
  test::expect_moved_source_composes(hough_matcher(), kHalfWidth);
}

TEST(AffineHough, TheOrderOfThePointsDoesNotMatter) {
  test::expect_order_does_not_matter(hough_matcher(), kHalfWidth);
}

TEST(AffineHough, NoMirrorImageMatches) { test::expect_no_mirror_image_matches(hough_matcher()); }

TEST(AffineHough, SurvivesPoorInputs) { test::expect_poor_inputs_are_survived(hough_matcher()); }

TEST(AffineHough, RemembersNothing) {
  test::expect_no_memory_of_earlier_matches(hough_matcher(), kHalfWidth);
}

// The fullest block by the book: a counter for each block of each heading.
std::size_t fullest_block(const MatchPoints& source, const MatchPoints& target,
                          const AffineHoughParams& params) {
  const auto headings = std::lround(kTwoPi / params.heading_step);
  const double cells = std::ceil(2.0 * params.range / params.cell);
  std::size_t fullest = 0;
  for (long k = 0; k < headings; ++k) {
    const double heading =
        -kPi + (static_cast<double>(k) + 0.5) * kTwoPi / static_cast<double>(headings);
    std::map<std::pair<double, double>, std::size_t> votes;
    for (const MatchPoint& p : source) {
      for (const MatchPoint& q : target) {
        const double own = q.orientation - p.orientation;
        if (std::abs(wrap_angle(own - heading)) > params.orientation_gate) continue;
        const Eigen::Vector2d t = q.position - Pose2(0.0, 0.0, heading) * p.position;
        const double x = std::floor((t.x() + params.range) / params.cell);
        const double y = std::floor((t.y() + params.range) / params.cell);
        if (x < 0.0 || y < 0.0 || x >= cells || y >= cells) continue;
        for (const double dx : {0.0, 1.0}) {
          for (const double dy : {0.0, 1.0}) {
            fullest = std::max(fullest, ++votes[{x + dx, y + dy}]);
          }
        }
      }
    }
  }
  return fullest;
}

TEST(AffineHough, FindsTheFullestBlock) {
  auto random = test::seeded_random();
  AffineHoughParams params;
  for (int run = 0; run < 20; ++run) {
    params.orientation_gate = run % 2 == 0 ? kPi : 1.05;
    params.range = run % 3 == 0 ? 2.03 : 5.0;
    const MatchPoints source = test::random_match_points(8, 3.0, random);
    const MatchPoints target = test::random_match_points(7, 3.0, random);
    AffineHoughMatcher matcher(params);
    matcher.match(source, target);
    EXPECT_EQ(matcher.votes(), fullest_block(source, target, params));
  }
}

// The thesis looks at half of the headings only.
TEST(AffineHough, FindsOppositeHeadings) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 4.0, random);
  const MatchResult result =
      AffineHoughMatcher().match(points, test::moved({0.0, 0.0, kPi}, points));
  EXPECT_EQ(result.pairs.size(), 8U);
}

TEST(AffineHough, CellBordersDoNotSplitTheVotes) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 3.0, random);
  for (const double x : {0.0, 0.05, 0.1, -0.1, 0.099999}) {
    const Pose2 pose(x, -x, 0.0);
    const MatchResult result =
        AffineHoughMatcher().match(points, test::moved(pose, test::shaken(points, 0.01, random)));
    EXPECT_EQ(result.pairs.size(), 8U) << x;
  }
}

TEST(AffineHough, LooksNoFartherThanItsRange) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 3.0, random);
  EXPECT_EQ(AffineHoughMatcher().match(points, test::moved({4.8, -4.8, 1.0}, points)).pairs.size(),
            8U);
  EXPECT_LT(AffineHoughMatcher().match(points, test::moved({6.0, 0.0, 1.0}, points)).pairs.size(),
            4U);
}

TEST(AffineHough, PairsOnlyWhatMayMatch) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 3.0, random);
  const MatchResult result = AffineHoughMatcher().match(
      points, points, [](std::size_t s, std::size_t t) { return s != 3 && t != 4; });
  EXPECT_EQ(result.pairs.size(), 6U);
}

TEST(AffineHough, RefusesParametersOutOfRange) {
  AffineHoughParams params;
  params.cell = 0.0;
  EXPECT_THROW(AffineHoughMatcher{params}, std::invalid_argument);
  params = {};
  params.heading_step = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.range = 100.0;
  params.cell = 0.01;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
