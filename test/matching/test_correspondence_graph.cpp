// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/correspondence_graph.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/match_relations.hpp"

namespace falko_slam {
namespace {

using test::MatchPoints;

test::Matcher graph_matcher() {
  auto matcher = std::make_shared<CorrespondenceGraphMatcher>();
  return [=](const MatchPoints& source, const MatchPoints& target, const Pose2&) {
    return matcher->match(source, target);
  };
}

TEST(CorrespondenceGraph, FindsTheMotion) { test::expect_finds_the_motion(graph_matcher(), 0); }

TEST(CorrespondenceGraph, FindsTheMotionAmongOutliers) {
  test::expect_finds_the_motion(graph_matcher(), 6);
}

TEST(CorrespondenceGraph, SwappedInputsGiveTheInverse) {
  test::expect_swapped_inputs_give_the_inverse(graph_matcher());
}

TEST(CorrespondenceGraph, AMovedSourceComposes) {
  test::expect_moved_source_composes(graph_matcher());
}

TEST(CorrespondenceGraph, TheOrderOfThePointsDoesNotMatter) {
  test::expect_order_does_not_matter(graph_matcher());
}

TEST(CorrespondenceGraph, NoMirrorImageMatches) {
  test::expect_no_mirror_image_matches(graph_matcher());
}

TEST(CorrespondenceGraph, SurvivesPoorInputs) {
  test::expect_poor_inputs_are_survived(graph_matcher());
}

TEST(CorrespondenceGraph, RemembersNothing) {
  test::expect_no_memory_of_earlier_matches(graph_matcher());
}

TEST(CorrespondenceGraph, FindsTheMotionWithoutOrientations) {
  test::expect_finds_the_motion(
      [](const MatchPoints& source, const MatchPoints& target, const Pose2&) {
        return CorrespondenceGraphMatcher().match(test::without_orientation(source),
                                                  test::without_orientation(target));
      },
      6);
}

// What the header promises, written down plainly: heading by heading, set by set.
class Definition {
 public:
  Definition(const MatchPoints& source, const MatchPoints& target)
      : source_(source), target_(target) {}

  std::size_t largest_match() {
    std::vector<double> headings = {0.0};  // an arc that others meet holds an end of one of them
    for_each_two_pairs([&](const MatchPair& a, const MatchPair& b) {
      const double slack = std::asin(std::min(1.0, kTolerance / shorter(a, b)));
      headings.push_back(turn(a, b) - slack + kHair);
      headings.push_back(turn(a, b) + slack - kHair);
    });
    for_each_pair([&](const MatchPair& a) {
      const double own = target_[a.target].orientation - source_[a.source].orientation;
      if (std::isnan(own)) return;
      headings.push_back(own - kGate + kHair);
      headings.push_back(own + kGate - kHair);
    });
    for (const double heading : headings) {
      std::vector<MatchPair> candidates;
      for_each_pair([&](const MatchPair& a) {
        const double own = target_[a.target].orientation - source_[a.source].orientation;
        if (std::isnan(own) || std::abs(wrap_angle(own - heading)) <= kGate) {
          candidates.push_back(a);
        }
      });
      grow({}, candidates, heading);
    }
    return best_ < 2 ? 0 : best_;
  }

 private:
  static constexpr double kTolerance = 0.10;
  static constexpr double kGate = 1.05;
  static constexpr double kHair = 1e-8;

  template <class Visit>
  void for_each_pair(Visit visit) const {
    for (std::size_t s = 0; s < source_.size(); ++s) {
      for (std::size_t t = 0; t < target_.size(); ++t) visit(MatchPair{s, t});
    }
  }
  template <class Visit>
  void for_each_two_pairs(Visit visit) const {
    for_each_pair([&](const MatchPair& a) {
      for_each_pair([&](const MatchPair& b) {
        if (a.source != b.source && a.target != b.target) visit(a, b);
      });
    });
  }
  Eigen::Vector2d source_span(const MatchPair& a, const MatchPair& b) const {
    return source_[b.source].position - source_[a.source].position;
  }
  Eigen::Vector2d target_span(const MatchPair& a, const MatchPair& b) const {
    return target_[b.target].position - target_[a.target].position;
  }
  double shorter(const MatchPair& a, const MatchPair& b) const {
    return std::min(source_span(a, b).norm(), target_span(a, b).norm());
  }
  double turn(const MatchPair& a, const MatchPair& b) const {
    const Eigen::Vector2d s = source_span(a, b);
    const Eigen::Vector2d t = target_span(a, b);
    return std::atan2(t.y(), t.x()) - std::atan2(s.y(), s.x());
  }
  bool compatible(const MatchPair& a, const MatchPair& b, double heading) const {
    if (a.source == b.source || a.target == b.target) return false;
    if (std::abs(source_span(a, b).norm() - target_span(a, b).norm()) >= kTolerance) return false;
    if (shorter(a, b) <= kTolerance) return true;
    return std::abs(wrap_angle(turn(a, b) - heading)) <= std::asin(kTolerance / shorter(a, b));
  }
  void grow(const std::vector<MatchPair>& chosen, const std::vector<MatchPair>& candidates,
            double heading) {
    best_ = std::max(best_, chosen.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      std::vector<MatchPair> more = chosen;
      more.push_back(candidates[i]);
      std::vector<MatchPair> left;
      for (std::size_t j = i + 1; j < candidates.size(); ++j) {
        if (compatible(candidates[i], candidates[j], heading)) left.push_back(candidates[j]);
      }
      grow(more, left, heading);
    }
  }

  const MatchPoints& source_;
  const MatchPoints& target_;
  std::size_t best_ = 0;
};

// Points crowded enough that many sets fit by chance, or nearly.
MatchPoints crowd(std::size_t count, double half_width, std::mt19937_64& random) {
  MatchPoints points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = test::uniform(random, -half_width, half_width);
    const double y = test::uniform(random, -half_width, half_width);
    points.push_back({{x, y}, test::uniform(random, -kPi, kPi)});
  }
  return points;
}

TEST(CorrespondenceGraph, IsAsLargeAsItsDefinitionSays) {
  auto random = test::seeded_random();
  CorrespondenceGraphMatcher matcher;
  for (int run = 0; run < 150; ++run) {
    const double half_width = run % 3 == 0 ? 0.15 : run % 3 == 1 ? 0.4 : 1.0;
    MatchPoints source = crowd(5, half_width, random);
    MatchPoints target = crowd(4, half_width, random);
    if (run % 2 == 0) source = test::without_orientation(source);
    const MatchResult result = matcher.match(source, target);
    EXPECT_TRUE(result.proven);
    EXPECT_EQ(result.pairs.size(), Definition(source, target).largest_match());
  }
}

TEST(CorrespondenceGraph, IsAsLargeAsItsDefinitionSaysForNoisyViews) {
  auto random = test::seeded_random();
  CorrespondenceGraphMatcher matcher;
  for (int run = 0; run < 60; ++run) {
    const MatchPoints source = test::random_match_points(6, 2.0, random);
    const Pose2 pose(1.0, 0.0, test::uniform(random, -kPi, kPi));
    const MatchPoints target = test::moved(pose, test::shaken(source, 0.05, random));
    EXPECT_EQ(matcher.match(source, target).pairs.size(),
              Definition(source, target).largest_match());
  }
}

// Distances alone would pair all of them.
TEST(CorrespondenceGraph, DoesNotTakeARoomForItsMirrorImage) {
  const MatchPoints room = {{{0.0, 0.0}}, {{4.0, 0.0}}, {{4.0, 2.0}}, {{1.2, 3.1}}, {{0.0, 5.5}}};
  const MatchResult result = CorrespondenceGraphMatcher().match(room, test::mirrored(room));
  EXPECT_TRUE(result.proven);
  EXPECT_LE(result.pairs.size(), 2U);
  EXPECT_EQ(CorrespondenceGraphMatcher().match(room, room).pairs.size(), 5U);
}

// Points in a line are their own mirror image: to match them is right.
TEST(CorrespondenceGraph, MatchesWhatIsItsOwnMirrorImage) {
  const MatchPoints line = {{{0.0, 0.0}}, {{1.0, 0.0}}, {{3.0, 0.0}}, {{7.0, 0.0}}};
  EXPECT_EQ(CorrespondenceGraphMatcher().match(line, test::mirrored(line)).pairs.size(), 4U);
}

TEST(CorrespondenceGraph, AsksOrientationsToConfirmTheHeading) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 5.0, random);
  MatchPoints turned = points;
  turned[2].orientation += kPi;
  turned[5].orientation -= 1.0;  // within the gate
  const MatchResult result = CorrespondenceGraphMatcher().match(points, turned);
  EXPECT_EQ(result.pairs.size(), 7U);
  EXPECT_EQ(std::count(result.pairs.begin(), result.pairs.end(), MatchPair{2, 2}), 0);
}

TEST(CorrespondenceGraph, PairsOnlyWhatMayMatch) {
  auto random = test::seeded_random();
  const MatchPoints points = test::random_match_points(8, 5.0, random);
  const MatchResult result = CorrespondenceGraphMatcher().match(
      points, points, [](std::size_t s, std::size_t t) { return s != 3 && s == t; });
  EXPECT_EQ(result.pairs.size(), 7U);
}

TEST(CorrespondenceGraph, SaysWhenTheNodesRanOut) {
  auto random = test::seeded_random();
  const test::TwoViews views = test::two_views({1.0, 2.0, 3.0}, 10, random);
  CorrespondenceGraphParams params;
  params.max_nodes = 3;
  const MatchResult result = CorrespondenceGraphMatcher(params).match(views.source, views.target);
  EXPECT_FALSE(result.proven);
  EXPECT_EQ(result.search_nodes, 3U);
}

// Each of the points may take the place of each other one.
TEST(CorrespondenceGraph, CopesWithPointsCloserThanItsTolerance) {
  auto random = test::seeded_random();
  const MatchPoints points = crowd(9, 0.03, random);
  const MatchResult result = CorrespondenceGraphMatcher().match(test::without_orientation(points),
                                                                test::without_orientation(points));
  EXPECT_TRUE(result.proven);
  EXPECT_EQ(result.pairs.size(), 9U);
}

TEST(CorrespondenceGraph, ProvesTheMatchOfARegularGrid) {
  MatchPoints grid;
  for (int i = 0; i < 25; ++i) grid.push_back({{1.0 * (i % 5), 1.0 * (i / 5)}});
  const MatchResult result = CorrespondenceGraphMatcher().match(grid, grid);
  EXPECT_TRUE(result.proven);
  EXPECT_EQ(result.pairs.size(), 25U);
}

TEST(CorrespondenceGraph, RefusesParametersOutOfRange) {
  CorrespondenceGraphParams params;
  params.distance_tolerance = 0.0;
  EXPECT_THROW(CorrespondenceGraphMatcher{params}, std::invalid_argument);
  params = {};
  params.orientation_gate = 2.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
