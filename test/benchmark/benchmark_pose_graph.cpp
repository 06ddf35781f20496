// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time of optimising pose graphs: recorded ones as a whole, from their start by the constraints,
// and simulated ones of 10 000 nodes at a single closure, the graph having been kept up to date
// until then.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "falko_slam/pose_graph/g2o_file.hpp"
#include "falko_slam/pose_graph/initial_guess.hpp"
#include "falko_slam/pose_graph/optimizer.hpp"
#include "support/simulated_graphs.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kNodes = 10000;

OptimizerParams without_loss() {
  OptimizerParams params;
  params.closure_loss = Loss::kNone;
  return params;
}

void optimize_recorded(benchmark::State& state, const char* name) {
  const char* folder = std::getenv("FALKO_SLAM_DATA");
  const std::string path = std::string(folder ? folder : ".") + "/pose_graphs/" + name + ".g2o.gz";
  if (!std::ifstream(path)) {
    state.SkipWithError((path + " is not there").c_str());
    return;
  }
  const PoseGraph graph = read_g2o(path).graph;
  for (auto _ : state) {
    PoseGraphOptimizer optimizer(guess_poses(graph, Guess::kBetter).graph, without_loss());
    const OptimizationSummary summary = optimizer.optimize();
    state.counters["chi2"] = summary.final_chi2;
    state.counters["iterations"] = summary.iterations;
  }
}
BENCHMARK_CAPTURE(optimize_recorded, intel, "intel")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(optimize_recorded, mit, "mit")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(optimize_recorded, m3500, "m3500")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(optimize_recorded, csail, "csail")->Unit(benchmark::kMillisecond);

// Brings the graph to its optimum, then adds the rest of the drive; an iteration is the update at a
// closure, `worst` the longest of them [ms].
void update_at_closures(benchmark::State& state, const PoseGraph& graph, std::size_t first_timed) {
  PoseGraphOptimizer optimizer;
  std::size_t next = 0;
  double worst = 0.0;
  const auto drive_to_closure = [&](std::size_t end) {
    while (next < end) {
      const GraphConstraint& constraint = graph.constraints[next++];
      if (constraint.kind == ConstraintKind::kOdometry) {
        optimizer.add_node({constraint.to, optimizer.pose(constraint.from) * constraint.from_T_to});
      }
      optimizer.add_constraint(constraint);
      if (constraint.kind == ConstraintKind::kClosure) return true;
    }
    return false;
  };
  optimizer.add_node(graph.nodes.front());
  while (next < first_timed) {
    if (drive_to_closure(first_timed)) optimizer.update();
  }
  for (auto _ : state) {
    if (!drive_to_closure(graph.constraints.size())) {
      state.SkipWithError("more iterations than closures: --benchmark_min_time is too long");
      break;
    }
    const auto begin = std::chrono::steady_clock::now();
    optimizer.update();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    state.SetIterationTime(time.count());
    worst = std::max(worst, 1e3 * time.count());
  }
  state.counters["worst"] = worst;
}

void update_grid(benchmark::State& state) {
  auto random = test::seeded_random();
  const PoseGraph graph = test::drive_grid(kNodes, {}, random).graph;
  const std::size_t closures = 100;
  update_at_closures(state, graph, graph.constraints.size() - 4 * closures);
}
BENCHMARK(update_grid)->Iterations(100)->UseManualTime()->Unit(benchmark::kMillisecond);

void update_rounds(benchmark::State& state) {
  auto random = test::seeded_random();
  const PoseGraph graph = test::drive_rounds(kNodes, 2500, 500, {}, random).graph;
  update_at_closures(state, graph, graph.constraints.size() - 2100);
}
BENCHMARK(update_rounds)->Iterations(4)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
