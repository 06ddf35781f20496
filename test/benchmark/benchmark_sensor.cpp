// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// De-skew of a scan of 1440 beams in an office, taken at 1 m/s and 1 rad/s.
#include <benchmark/benchmark.h>

#include "support/moving_scans.hpp"

namespace falko_slam {
namespace {

void deskew_nav350(benchmark::State& state) {
  std::mt19937_64 random(1);
  const test::MovingLaser laser = test::moving_laser(1440, 0.01);
  const Pose2 way = Pose2::exp({0.125, 0.0, 0.125});
  const LaserScan scan = laser.scan(office_scene(), {-3.0, -1.0, 0.7}, way, random);
  for (auto _ : state) {
    benchmark::DoNotOptimize(deskew(scan, {way, test::kRevolution}, laser.stamp));
  }
}
BENCHMARK(deskew_nav350)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
