// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The occupancy grid on a recording: beams added per second, and the map as values and as PNG.
#include <benchmark/benchmark.h>

#include "falko_slam/map/occupancy_grid.hpp"
#include "falko_slam/map/png_file.hpp"
#include "recorded_scans.hpp"

namespace falko_slam {
namespace {

const std::vector<PosedScan>& recording() {
  static const std::vector<PosedScan> scans = benchmarks::recorded_scans();
  return scans;
}

OccupancyGrid whole_grid() {
  OccupancyGrid grid;
  for (const PosedScan& posed : recording()) grid.add(posed.scan, posed.map_T_laser);
  return grid;
}

void add_beams(benchmark::State& state) {
  std::int64_t beams = 0;
  for (const PosedScan& posed : recording()) {
    for (std::size_t i = 0; i < posed.scan.size(); ++i) beams += posed.scan.valid(i) ? 1 : 0;
  }
  for (auto _ : state) benchmark::DoNotOptimize(whole_grid());
  state.SetItemsProcessed(state.iterations() * beams);
}

void rasterise(benchmark::State& state) {
  const OccupancyGrid grid = whole_grid();
  for (auto _ : state) benchmark::DoNotOptimize(grid.rasterise());
}

void as_png(benchmark::State& state) {
  const GrayImage image = trinary_image(whole_grid().rasterise());
  for (auto _ : state) benchmark::DoNotOptimize(png_bytes(image));
}

BENCHMARK(add_beams)->Unit(benchmark::kMillisecond);
BENCHMARK(rasterise)->Unit(benchmark::kMillisecond);
BENCHMARK(as_png)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
