// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time of the matchers: on random point sets, half of which are common if not said otherwise, and
// on the keypoints of fr079 (the literal reading of FALKO), where an iteration matches a scan with
// ten candidates. `median` and `p99` are those of the iterations, CPU time [us].
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <numeric>
#include <random>

#include "falko_slam/evaluation/literal_falko.hpp"
#include "falko_slam/matching/affine_hough.hpp"
#include "falko_slam/matching/correspondence_graph.hpp"
#include "falko_slam/matching/nearest_neighbor.hpp"
#include "falko_slam/matching/ransac.hpp"
#include "falko_slam/matching/two_point_matcher.hpp"
#include "recorded_scans.hpp"

namespace falko_slam {
namespace {

using Points = std::vector<MatchPoint>;

// A set, and those it is matched with.
struct Query {
  Points source;
  std::vector<Points> targets;
  std::vector<Pose2> target_T_source;  // the true ones
};

struct RandomSets {
  std::size_t points, common;
  double half_width;         // of the square they lie in [m]
  double orientation_noise;  // 0: no orientations [rad]
};

std::vector<Query> random_queries(const RandomSets& sets) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-sets.half_width, sets.half_width);
  std::uniform_real_distribution<double> heading(-kPi, kPi);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::normal_distribution<double> turn(0.0, std::max(1e-9, sets.orientation_noise));
  std::vector<Query> queries;
  for (int run = 0; run < 50; ++run) {
    const Pose2 pose(3.0, -2.0, heading(random));
    Query query{{}, {{}}, {pose}};
    for (std::size_t i = 0; i < sets.points; ++i) {
      MatchPoint point{{place(random), place(random)}};
      if (sets.orientation_noise > 0.0) point.orientation = heading(random);
      query.source.push_back(point);
      if (i >= sets.common) point.position = {place(random), place(random)};
      point.position = pose * point.position + Eigen::Vector2d(noise(random), noise(random));
      point.orientation += pose.theta() + turn(random);
      query.targets[0].push_back(point);
    }
    queries.push_back(query);
  }
  return queries;
}

// Every scan with the ten others taken nearest to it, or with any ten.
enum class Candidates { kNearest, kAny };

std::vector<Query> recorded_queries(Candidates candidates) {
  static const std::vector<PosedScan> scans = benchmarks::recorded_scans();
  static std::vector<Points> points;
  for (std::size_t i = points.size(); i < scans.size(); ++i) {
    points.emplace_back();
    for (const Keypoint& keypoint : literal_falko(scans[i].scan)) {
      points.back().push_back({keypoint.position, keypoint.orientation});
    }
  }
  constexpr std::ptrdiff_t kCandidates = 10;
  std::mt19937_64 random(1);
  std::vector<Query> queries;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    std::vector<std::size_t> order(scans.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::swap(order[i], order.back());
    order.pop_back();
    const auto distance = [&](std::size_t j) {
      return (scans[j].map_T_laser.translation() - scans[i].map_T_laser.translation()).norm();
    };
    if (candidates == Candidates::kNearest) {
      std::partial_sort(order.begin(), order.begin() + kCandidates, order.end(),
                        [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    } else {
      std::shuffle(order.begin(), order.end(), random);
    }
    Query query{points[i], {}, {}};
    for (std::ptrdiff_t j = 0; j < kCandidates; ++j) {
      const std::size_t other = order[static_cast<std::size_t>(j)];
      query.targets.push_back(points[other]);
      query.target_T_source.push_back(scans[other].map_T_laser.inverse() * scans[i].map_T_laser);
    }
    queries.push_back(query);
  }
  return queries;
}

const std::vector<Query>& nearest() {
  static const std::vector<Query> queries = recorded_queries(Candidates::kNearest);
  return queries;
}
const std::vector<Query>& any() {
  static const std::vector<Query> queries = recorded_queries(Candidates::kAny);
  return queries;
}
const std::vector<Query>& eighty() {
  static const std::vector<Query> queries = random_queries({80, 40, 10.0, 0.0});
  return queries;
}
const std::vector<Query>& strangers() {
  static const std::vector<Query> queries = random_queries({80, 0, 10.0, 0.0});
  return queries;
}
const std::vector<Query>& fifteen() {
  static const std::vector<Query> queries = random_queries({15, 7, 8.0, 0.1});
  return queries;
}

// Matchers by the same name: match(source, target, rough target_T_source).
struct CorrespondenceGraph {
  CorrespondenceGraphMatcher matcher;
  MatchResult operator()(const Points& source, const Points& target, const Pose2&) {
    return matcher.match(source, target);
  }
};
struct CorrespondenceGraphByDistances {
  CorrespondenceGraphMatcher matcher;
  Points without(Points points) {
    for (MatchPoint& point : points) point.orientation = MatchPoint().orientation;
    return points;
  }
  MatchResult operator()(const Points& source, const Points& target, const Pose2&) {
    return matcher.match(without(source), without(target));
  }
};
struct AffineHough {
  AffineHoughMatcher matcher;
  MatchResult operator()(const Points& source, const Points& target, const Pose2&) {
    return matcher.match(source, target);
  }
};
struct AffineHoughByPositions {
  static AffineHoughParams params() {
    AffineHoughParams params;
    params.orientation_gate = kPi;
    return params;
  }
  AffineHoughMatcher matcher{params()};
  MatchResult operator()(const Points& source, const Points& target, const Pose2&) {
    return matcher.match(source, target);
  }
};
struct Ransac {
  std::mt19937_64 random{1};
  MatchResult operator()(const Points& source, const Points& target, const Pose2&) {
    return match_by_ransac(source, target, random);
  }
};
struct NearestNeighbor {
  MatchResult operator()(const Points& source, const Points& target, const Pose2& rough) {
    return match_nearest_neighbors(source, target, rough);
  }
};
struct TwoPoint {
  TwoPointMatcher matcher;
  MatchResult operator()(const Points& source, const Points& target, const Pose2&) {
    const auto matches = matcher.match(source, target);
    return matches.empty() ? MatchResult() : matches.front();
  }
};

double percentile(std::vector<double>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

template <class Matcher, const std::vector<Query>& (*queries)()>
void match(benchmark::State& state) {
  const std::vector<Query>& all = queries();
  Matcher matcher;
  std::vector<double> times;
  std::size_t pairs = 0;
  std::size_t proven = 0;
  std::size_t matches = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    const Query& query = all[next];
    if (++next == all.size()) next = 0;
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < query.targets.size(); ++i) {
      const MatchResult result = matcher(query.source, query.targets[i], query.target_T_source[i]);
      pairs += result.pairs.size();
      proven += result.proven ? 1 : 0;
    }
    times.push_back(1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    matches += query.targets.size();
  }
  state.counters["median"] = percentile(times, 0.5);
  state.counters["p99"] = percentile(times, 0.99);
  state.counters["proven"] = static_cast<double>(proven) / static_cast<double>(matches);
  state.counters["pairs"] = static_cast<double>(pairs) / static_cast<double>(matches);
}

#define MATCH(name, matcher, queries) \
  BENCHMARK_TEMPLATE(match, matcher, queries)->Name(name)->Unit(benchmark::kMicrosecond)

MATCH("correspondence graph/80 x 80 random", CorrespondenceGraph, eighty);
MATCH("correspondence graph/80 x 80 random, none common", CorrespondenceGraph, strangers);
MATCH("correspondence graph/15 x 15 random", CorrespondenceGraph, fifteen);
MATCH("correspondence graph/10 nearest", CorrespondenceGraph, nearest);
MATCH("correspondence graph/10 any", CorrespondenceGraph, any);
MATCH("correspondence graph, no orientations/10 nearest", CorrespondenceGraphByDistances, nearest);
MATCH("correspondence graph, no orientations/10 any", CorrespondenceGraphByDistances, any);
MATCH("affine Hough/10 nearest", AffineHough, nearest);
MATCH("affine Hough/10 any", AffineHough, any);
MATCH("affine Hough, no orientations/10 nearest", AffineHoughByPositions, nearest);
MATCH("RANSAC/10 nearest", Ransac, nearest);
MATCH("RANSAC/10 any", Ransac, any);
MATCH("nearest neighbor/10 nearest", NearestNeighbor, nearest);
MATCH("two-point/15 x 15 random", TwoPoint, fifteen);
MATCH("two-point/10 nearest", TwoPoint, nearest);
MATCH("two-point/10 any", TwoPoint, any);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
