// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/point_sets.hpp"
#include "support/poses.hpp"

namespace falko_slam {
namespace test {

/// What the relations below hold for: a match of two sets, given a rough target_T_source that most
/// matchers do without.
using Matcher = std::function<MatchResult(const MatchPoints& source, const MatchPoints& target,
                                          const Pose2& guess)>;

/// Two views of the same points, the first `common` ones, each with points of its own after them.
struct TwoViews {
  MatchPoints source, target;
  Pose2 target_T_source;
  std::size_t common;
};

inline TwoViews two_views(const Pose2& target_T_source, std::size_t outliers,
                          std::mt19937_64& random, double half_width = 6.0) {
  constexpr std::size_t kCommon = 12;
  const MatchPoints points = random_match_points(kCommon, half_width, random);
  TwoViews views{points, points, target_T_source, kCommon};
  add_points(views.source, outliers, half_width, random);
  add_points(views.target, outliers, half_width, random);
  views.source = shaken(views.source, 0.01, random);
  views.target = moved(target_T_source, shaken(views.target, 0.01, random));
  return views;
}

inline MatchResult match(const Matcher& matcher, const TwoViews& views) {
  return matcher(views.source, views.target, views.target_T_source);
}

inline void expect_finite(const MatchResult& result) {
  EXPECT_EQ(result.found(), result.pairs.size() >= 2);
  if (!result.found()) return;
  EXPECT_TRUE(result.target_T_source->pose.translation().allFinite());
  EXPECT_TRUE(std::isfinite(result.target_T_source->pose.theta()));
  EXPECT_TRUE(result.target_T_source->covariance.allFinite());
  EXPECT_TRUE(std::isfinite(result.rms_residual));
}

inline void expect_common_pairs(const MatchResult& result, const TwoViews& views) {
  ASSERT_TRUE(result.found());
  std::vector<MatchPair> common;
  for (std::size_t i = 0; i < views.common; ++i) common.push_back({i, i});
  EXPECT_EQ(result.pairs, common);
  expect_near(result.target_T_source->pose, views.target_T_source, 0.03);
}

inline void expect_finds_the_motion(const Matcher& matcher, std::size_t outliers,
                                    double half_width = 6.0) {
  auto random = seeded_random();
  for (const double heading : edge_headings()) {
    SCOPED_TRACE(heading);
    const TwoViews views = two_views({1.5, -2.5, heading}, outliers, random, half_width);
    expect_common_pairs(match(matcher, views), views);
  }
}

inline void expect_swapped_inputs_give_the_inverse(const Matcher& matcher,
                                                   double half_width = 6.0) {
  auto random = seeded_random();
  for (const double heading : edge_headings()) {
    SCOPED_TRACE(heading);
    const TwoViews views = two_views({1.0, 2.0, heading}, 4, random, half_width);
    const MatchResult forward = match(matcher, views);
    const MatchResult back = matcher(views.target, views.source, views.target_T_source.inverse());
    ASSERT_TRUE(forward.found() && back.found());
    ASSERT_EQ(forward.pairs.size(), back.pairs.size());
    expect_near(forward.target_T_source->pose * back.target_T_source->pose, Pose2(), 1e-9);
  }
}

inline void expect_moved_source_composes(const Matcher& matcher, double half_width = 6.0) {
  auto random = seeded_random();
  const TwoViews views = two_views({0.5, 0.5, 0.3}, 4, random, half_width);
  const MatchResult plain = match(matcher, views);
  ASSERT_TRUE(plain.found());
  for (const double heading : edge_headings()) {
    SCOPED_TRACE(heading);
    const Pose2 moved_T_source(0.4, -0.2, heading);
    const MatchResult result = matcher(moved(moved_T_source, views.source), views.target,
                                       views.target_T_source * moved_T_source.inverse());
    ASSERT_TRUE(result.found());
    EXPECT_EQ(result.pairs, plain.pairs);
    expect_near(result.target_T_source->pose * moved_T_source, plain.target_T_source->pose, 1e-9);
  }
}

inline void expect_order_does_not_matter(const Matcher& matcher, double half_width = 6.0) {
  auto random = seeded_random();
  const TwoViews views = two_views({1.0, -1.0, 2.0}, 5, random, half_width);
  const MatchResult plain = match(matcher, views);
  for (int run = 0; run < 20; ++run) {
    const auto source_order = shuffled_order(views.source.size(), random);
    const auto target_order = shuffled_order(views.target.size(), random);
    const MatchResult result = matcher(in_order(source_order, views.source),
                                       in_order(target_order, views.target), views.target_T_source);
    std::vector<MatchPair> pairs;
    for (const MatchPair& pair : result.pairs) {
      pairs.push_back({source_order[pair.source], target_order[pair.target]});
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const MatchPair& a, const MatchPair& b) { return a.source < b.source; });
    EXPECT_EQ(pairs, plain.pairs);
  }
}

/// How many points at most some motion takes near points of the mirror image of the same set.
inline std::size_t mirror_symmetry(const MatchPoints& points) {
  constexpr double kNear = 0.4;
  const MatchPoints image = mirrored(points);
  std::size_t most = 0;
  const auto near_image = [&](const Eigen::Vector2d& point) {
    return std::any_of(image.begin(), image.end(), [&](const MatchPoint& other) {
      return (other.position - point).norm() < kNear;
    });
  };
  for (std::size_t i = 0; i < points.size() * points.size(); ++i) {
    for (std::size_t j = 0; j < points.size() * points.size(); ++j) {
      const MatchPair a{i % points.size(), i / points.size()};
      const MatchPair b{j % points.size(), j / points.size()};
      if (a.source == b.source || a.target == b.target) continue;
      const MatchResult motion = match_of({a, b}, points, image, 0.0);
      if (!motion.found() || motion.rms_residual > kNear) continue;
      most = std::max(most, static_cast<std::size_t>(std::count_if(
                                points.begin(), points.end(), [&](const MatchPoint& point) {
                                  return near_image(motion.target_T_source->pose * point.position);
                                })));
    }
  }
  return most;
}

/// Half of the runs without orientations. Three pairs may fit: isosceles triangles are symmetric.
inline void expect_no_mirror_image_matches(const Matcher& matcher) {
  auto random = seeded_random();
  for (int run = 0; run < 50; ++run) {
    MatchPoints points = random_match_points(8, 8.0, random);
    while (mirror_symmetry(points) > 3) points = random_match_points(8, 8.0, random);
    if (run % 2 == 0) points = without_orientation(points);
    const Pose2 pose(0.3, 0.1, uniform(random, -kPi, kPi));
    const MatchResult result = matcher(points, moved(pose, mirrored(points)), pose);
    EXPECT_LT(result.pairs.size(), 4U);
  }
}

inline void expect_poor_inputs_are_survived(const Matcher& matcher) {
  auto random = seeded_random();
  const MatchPoints good = random_match_points(6, 5.0, random);
  MatchPoints broken = good;
  broken[1].position.x() = std::numeric_limits<double>::quiet_NaN();
  broken[2].position.y() = std::numeric_limits<double>::infinity();
  broken[3].position.x() = 1e300;
  broken[4].orientation = std::numeric_limits<double>::infinity();
  MatchPoints line;
  for (int i = 0; i < 6; ++i) line.push_back({{0.7 * i * i, 1.0}, kPi});
  const std::vector<MatchPoints> sets = {
      {}, {good[0]}, {good[0], good[1]}, MatchPoints(5, good[0]), line, broken, good};
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (std::size_t t = 0; t < sets.size(); ++t) {
      SCOPED_TRACE(std::to_string(s) + " against " + std::to_string(t));
      const MatchResult result = matcher(sets[s], sets[t], Pose2());
      expect_finite(result);
      const bool hopeless = std::min(s, t) < 2 || s == 3 || t == 3;
      EXPECT_FALSE(hopeless && result.found());
      for (const MatchPair& pair : result.pairs) {
        EXPECT_TRUE(sets[s][pair.source].usable() && sets[t][pair.target].usable());
      }
    }
  }
}

inline void expect_no_memory_of_earlier_matches(const Matcher& matcher, double half_width = 6.0) {
  auto random = seeded_random();
  const TwoViews views = two_views({1.0, -1.0, 2.0}, 5, random, half_width);
  const MatchResult first = match(matcher, views);
  match(matcher, two_views({-1.0, 0.0, -2.0}, 20, random, half_width));
  const MatchResult again = match(matcher, views);
  EXPECT_EQ(first.pairs, again.pairs);
  ASSERT_TRUE(first.found() && again.found());
  EXPECT_EQ(first.target_T_source->pose.x(), again.target_T_source->pose.x());
  EXPECT_EQ(first.search_nodes, again.search_nodes);
}

}  // namespace test
}  // namespace falko_slam
