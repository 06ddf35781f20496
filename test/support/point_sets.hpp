// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <ostream>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/matching/match_result.hpp"
#include "support/seeds.hpp"

namespace falko_slam {

inline void PrintTo(const MatchPair& pair, std::ostream* out) {
  *out << pair.source << "-" << pair.target;
}

namespace test {

using MatchPoints = std::vector<MatchPoint>;

/// The headings at which angles go wrong.
inline std::vector<double> edge_headings() {
  return {0.0, 1e-9, -1e-9, kPi, -kPi, kPi - 1e-9, 1e-9 - kPi, 3.0 * kPi, 0.7};
}

/// Adds points of the square [-half_width, half_width]^2, at least 0.6 m from each other.
inline void add_points(MatchPoints& points, std::size_t count, double half_width,
                       std::mt19937_64& random) {
  while (count > 0) {
    MatchPoint point;
    point.position = {uniform(random, -half_width, half_width),
                      uniform(random, -half_width, half_width)};
    point.orientation = uniform(random, -kPi, kPi);
    if (std::any_of(points.begin(), points.end(), [&](const MatchPoint& other) {
          return (other.position - point.position).norm() < 0.6;
        })) {
      continue;
    }
    points.push_back(point);
    --count;
  }
}

inline MatchPoints random_match_points(std::size_t count, double half_width,
                                       std::mt19937_64& random) {
  MatchPoints points;
  add_points(points, count, half_width, random);
  return points;
}

inline MatchPoints moved(const Pose2& pose, MatchPoints points) {
  for (MatchPoint& point : points) {
    point.position = pose * point.position;
    point.orientation += pose.theta();
  }
  return points;
}

inline MatchPoints mirrored(MatchPoints points) {
  for (MatchPoint& point : points) {
    point.position.y() *= -1.0;
    point.orientation *= -1.0;
  }
  return points;
}

inline MatchPoints without_orientation(MatchPoints points) {
  for (MatchPoint& point : points) point.orientation = MatchPoint().orientation;
  return points;
}

inline MatchPoints shaken(MatchPoints points, double noise, std::mt19937_64& random) {
  for (MatchPoint& point : points) {
    point.position += Eigen::Vector2d(normal(random, noise), normal(random, noise));
    point.orientation += normal(random, 0.1);
  }
  return points;
}

/// The order in which `shuffled` puts points: entry i is the old index of new point i.
inline std::vector<std::size_t> shuffled_order(std::size_t count, std::mt19937_64& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

inline MatchPoints in_order(const std::vector<std::size_t>& order, const MatchPoints& points) {
  MatchPoints result;
  for (const std::size_t index : order) result.push_back(points[index]);
  return result;
}

}  // namespace test
}  // namespace falko_slam
