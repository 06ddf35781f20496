// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The signature index, exact and by brute force, on jittered copies of the signatures of a
// recording; and the time of the loop detector for a scan.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <random>

#include "falko_slam/features/falko.hpp"
#include "falko_slam/place_recognition/glare.hpp"
#include "falko_slam/place_recognition/loop_detector.hpp"
#include "falko_slam/place_recognition/signature_index.hpp"
#include "recorded_scans.hpp"

namespace falko_slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;

const std::vector<PosedScan>& recording() {
  static const std::vector<PosedScan> scans = benchmarks::recorded_scans();
  return scans;
}

const std::vector<Points>& keypoints() {
  static const std::vector<Points> sets = [] {
    std::vector<Points> found;
    FalkoDetector falko;
    for (const PosedScan& posed : recording()) {
      Points points;
      for (const Keypoint& keypoint : falko.detect(posed.scan)) points.push_back(keypoint.position);
      if (points.size() >= 3) found.push_back(points);
    }
    return found;
  }();
  return sets;
}

// A scan as seen another time: turned, each point 3 cm off, one in ten missing.
Signature jittered(std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, 0.03);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const Points& points = keypoints()[random() % keypoints().size()];
  const Pose2 turn(0.0, 0.0, kTwoPi * share(random));
  Points seen;
  for (const Eigen::Vector2d& point : points) {
    if (share(random) < 0.1) continue;
    const double x = noise(random);
    seen.push_back(turn * point + Eigen::Vector2d(x, noise(random)));
  }
  return glare(seen);
}

const SignatureIndex& index_of(std::uint64_t size) {
  static std::map<std::uint64_t, SignatureIndex> known;
  const auto found = known.find(size);
  if (found != known.end()) return found->second;
  std::mt19937_64 random(size);
  SignatureIndex index(8, 50);
  for (std::uint64_t id = 0; id < size; ++id) index.add({id}, jittered(random));
  return known.emplace(size, std::move(index)).first->second;
}

template <class Search>
void search(benchmark::State& state, Search search_in) {
  const SignatureIndex& index = index_of(static_cast<std::uint64_t>(state.range(0)));
  std::mt19937_64 random(2);
  std::vector<Signature> queries;
  for (int i = 0; i < 200; ++i) queries.push_back(jittered(random));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search_in(index, queries[i]));
    if (++i == queries.size()) i = 0;
  }
}

void nearest(benchmark::State& state) {
  search(state, [](const SignatureIndex& index, const Signature& query) {
    return index.nearest(query, 10);
  });
}

void brute_force(benchmark::State& state) {
  search(state, [](const SignatureIndex& index, const Signature& query) {
    return index.nearest_by_brute_force(query, 10);
  });
}

void signature_of_keypoints(benchmark::State& state) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(glare(keypoints()[i]));
    if (++i == keypoints().size()) i = 0;
  }
}

void keyframe(benchmark::State& state) {
  KeyframeBuilder builder;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(builder.build(recording()[i].scan));
    if (++i == recording().size()) i = 0;
  }
}

// Search, association and verification of a scan among all the others.
void close_loop(benchmark::State& state) {
  LoopDetector detector;
  for (const PosedScan& posed : recording()) detector.add(posed.scan, posed.map_T_laser);
  std::uint64_t id = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        detector.detect({id}, [&](const Keyframe& target) { return target.id != KeyframeId{id}; }));
    if (++id == recording().size()) id = 0;
  }
}

BENCHMARK(nearest)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMicrosecond);
BENCHMARK(brute_force)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMicrosecond);
BENCHMARK(signature_of_keypoints)->Unit(benchmark::kMicrosecond);
BENCHMARK(keyframe)->Unit(benchmark::kMicrosecond);
BENCHMARK(close_loop)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
