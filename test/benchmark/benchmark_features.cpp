// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time per scan of the detectors and descriptors, on the scans of fr079 (360 beams over 180
// degrees) and their linear interpolations.
#include <benchmark/benchmark.h>

#include <map>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/features/beta_grid.hpp"
#include "falko_slam/features/descriptor_extractor.hpp"
#include "falko_slam/features/falko.hpp"
#include "falko_slam/features/flirt.hpp"
#include "falko_slam/features/orthogonal_corner.hpp"
#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "recorded_scans.hpp"
#include "support/reflector_worlds.hpp"

namespace falko_slam {
namespace {

// The scans with about `beams` beams: those left out or interpolated between the recorded ones.
const std::vector<LaserScan>& scans_of(int beams) {
  static const std::vector<PosedScan> recorded = benchmarks::recorded_scans();
  static std::map<int, std::vector<LaserScan>> known;
  std::vector<LaserScan>& scans = known[beams];
  if (!scans.empty()) return scans;
  for (const PosedScan& recording : recorded) {
    scans.push_back(
        beams < benchmarks::kBeams
            ? subsampled(recording.scan, static_cast<std::size_t>(benchmarks::kBeams / beams - 1))
            : oversampled(recording.scan,
                          static_cast<std::size_t>(beams / benchmarks::kBeams - 1)));
  }
  return scans;
}

// Runs `work` on one scan after the other; the time of an iteration is that of a scan.
template <class Work>
void for_each_scan(benchmark::State& state, std::size_t count, Work work) {
  std::size_t i = 0;
  for (auto _ : state) {
    work(i);
    if (++i == count) i = 0;
  }
}

void set_counters(benchmark::State& state, std::size_t keypoints) {
  state.counters["keypoints"] =
      benchmark::Counter(static_cast<double>(keypoints), benchmark::Counter::kAvgIterations);
  state.counters["per_beam"] = benchmark::Counter(
      static_cast<double>(state.range(0)) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Detector>
void detect(benchmark::State& state) {
  const auto& scans = scans_of(static_cast<int>(state.range(0)));
  Detector detector;
  std::vector<Keypoint> keypoints;
  std::size_t found = 0;
  for_each_scan(state, scans.size(), [&](std::size_t i) {
    detector.detect(scans[i], keypoints);
    found += keypoints.size();
  });
  set_counters(state, found);
}

struct FlirtRangeDetector : FlirtDetector {
  FlirtRangeDetector() : FlirtDetector(flirt_range_params()) {}
};

// `Features`: what the extractor fills.
template <class Detector, class Extractor, class Features>
void describe_keypoints(benchmark::State& state) {
  const auto& scans = scans_of(static_cast<int>(state.range(0)));
  Detector detector;
  std::vector<std::vector<Keypoint>> keypoints;
  for (const LaserScan& scan : scans) keypoints.push_back(detector.detect(scan));
  Extractor extractor;
  Features features;
  std::size_t described = 0;
  for_each_scan(state, scans.size(), [&](std::size_t i) {
    extractor.extract(scans[i], keypoints[i], features);
    described += features.size();
  });
  set_counters(state, described);
}

// 1440 beams, from the aisle across the shipped warehouse.
std::vector<LaserScan> warehouse_scans() {
  const Scenario scenario = read_scenario(FALKO_SLAM_SOURCE_DIR "/config/scenarios/warehouse.yaml");
  std::mt19937_64 random(1);
  std::vector<LaserScan> scans;
  for (double x = 8.0; x < 50.0; x += 1.0) {
    scans.push_back(test::look_at(scenario.world, {x, 6.5, 0.1 * x}, scenario.laser, random));
  }
  return scans;
}

void detect_reflectors(benchmark::State& state) {
  const std::vector<LaserScan> scans = warehouse_scans();
  ReflectorDetector detector;
  std::vector<DetectedReflector> found;
  std::size_t count = 0;
  for_each_scan(state, scans.size(), [&](std::size_t i) {
    detector.detect(scans[i], found);
    count += found.size();
  });
  state.counters["reflectors"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kAvgIterations);
}

BENCHMARK(detect_reflectors)->Name("reflectors")->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(detect, FalkoDetector)
    ->Name("FALKO")
    ->Arg(180)
    ->Arg(360)
    ->Arg(720)
    ->Arg(1440)
    ->Arg(2880)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(detect, OrthogonalCornerDetector)
    ->Name("OC")
    ->Arg(360)
    ->Arg(1440)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(detect, FlirtDetector)
    ->Name("FLIRT curvature")
    ->Arg(180)
    ->Arg(360)
    ->Arg(720)
    ->Arg(1440)
    ->Arg(2880)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(detect, FlirtRangeDetector)
    ->Name("FLIRT range")
    ->Arg(360)
    ->Arg(1440)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(describe_keypoints, FlirtDetector, BetaGridExtractor, std::vector<BetaGrid>)
    ->Name("beta-grid, FLIRT curvature")
    ->Arg(360)
    ->Arg(1440)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(describe_keypoints, FalkoDetector, BetaGridExtractor, std::vector<BetaGrid>)
    ->Name("beta-grid, FALKO")
    ->Arg(360)
    ->Arg(1440)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(describe_keypoints, FalkoDetector, DescriptorExtractor,
                   std::vector<DescribedKeypoint>)
    ->Name("BSC and CGH")
    ->Arg(360)
    ->Arg(1440)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
