// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A scan of 1440 beams, and a second of driving with all that belongs to it, without a bag.
#include <benchmark/benchmark.h>

#include <string>

#include "falko_slam/simulation/scenario_file.hpp"
#include "falko_slam/simulation/simulation.hpp"

namespace falko_slam {
namespace {

Scenario shipped(const std::string& name) {
  return read_scenario(FALKO_SLAM_SOURCE_DIR "/config/scenarios/" + name + ".yaml");
}

// Each iteration is a second of the vehicle's time: eight scans.
void drive_a_second(benchmark::State& state, const std::string& name) {
  const Scenario scenario = shipped(name);
  Simulation simulation(scenario, kSimulationStart, 1);
  auto driver = scenario_driver(scenario.drive, scenario.vehicle);
  for (auto _ : state) {
    for (int i = 0; i < 50; ++i) {
      const auto input = driver->next(simulation.vehicle(), simulation.period());
      benchmark::DoNotOptimize(simulation.step(input.value_or(DriveInput(WheelCommand{}))));
    }
  }
  state.counters["times_real_time"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(drive_a_second, warehouse, std::string("warehouse"))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drive_a_second, block_storage, std::string("block_storage"))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drive_a_second, office_loop, std::string("office_loop"))
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
