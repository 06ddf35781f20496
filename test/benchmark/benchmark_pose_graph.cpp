// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time of optimising pose graphs: recorded ones as a whole, from their start by the constraints,
// which of their closures are consistent, and simulated ones of 10 000 nodes at a single closure,
// the graph having been kept up to date until then.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "falko_slam/pose_graph/consistency.hpp"
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

// Empty, and the benchmark skipped, where it is not there.
PoseGraph recorded(benchmark::State& state, const char* name) {
  const char* folder = std::getenv("FALKO_SLAM_DATA");
  const std::string path = std::string(folder ? folder : ".") + "/pose_graphs/" + name + ".g2o.gz";
  if (std::ifstream(path)) return read_g2o(path).graph;
  state.SkipWithError((path + " is not there").c_str());
  return {};
}

void optimize_recorded(benchmark::State& state, const char* name) {
  const PoseGraph graph = recorded(state, name);
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

// Beside the closures of a recorded graph a fifth as many false ones between random nodes, in the
// order in which the vehicle would meet them. Counters: parts of the true and of the false ones
// that are accepted, and of the true ones that are refused (the rest is pending).
void select_recorded(benchmark::State& state, const char* name) {
  PoseGraph graph = recorded(state, name);
  auto random = test::seeded_random();
  const auto last_node = static_cast<double>(graph.nodes.size()) - 1.0;
  const auto node = [&] {
    return graph.nodes[static_cast<std::size_t>(test::uniform(random, 0.0, last_node))].id;
  };
  std::vector<std::pair<GraphConstraint, bool>> marked;  // true: false ones
  for (const GraphConstraint& constraint : graph.constraints) {
    marked.emplace_back(constraint, false);
    if (constraint.kind != ConstraintKind::kClosure) continue;
    if (test::uniform(random, 0.0, 1.0) > 0.2) continue;
    GraphConstraint wrong = constraint;
    do {
      wrong.from = node();
      wrong.to = node();
    } while (wrong.to.value < wrong.from.value + 10);
    wrong.from_T_to = Pose2(test::uniform(random, -1.0, 1.0), test::uniform(random, -1.0, 1.0),
                            test::uniform(random, -kPi, kPi));
    marked.emplace_back(wrong, true);
  }
  std::stable_sort(marked.begin(), marked.end(), [](const auto& a, const auto& b) {
    return std::max(a.first.from, a.first.to) < std::max(b.first.from, b.first.to);
  });
  graph.constraints.clear();
  for (const auto& [constraint, is_false] : marked) graph.constraints.push_back(constraint);
  std::vector<ClosureVerdict> verdicts;
  for (auto _ : state) verdicts = select_closures(graph);
  double true_ones = 0.0, false_ones = 0.0, found = 0.0, refused = 0.0, fooled = 0.0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (marked[i].first.kind != ConstraintKind::kClosure) continue;
    const bool accepted = verdicts[i] == ClosureVerdict::kAccepted;
    ++(marked[i].second ? false_ones : true_ones);
    if (accepted) ++(marked[i].second ? fooled : found);
    if (!accepted && !marked[i].second && verdicts[i] != ClosureVerdict::kPending) ++refused;
  }
  state.counters["true_accepted"] = found / true_ones;
  state.counters["true_refused"] = refused / true_ones;
  state.counters["false"] = false_ones;
  state.counters["false_accepted"] = fooled;
}
BENCHMARK_CAPTURE(select_recorded, intel, "intel")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(select_recorded, mit, "mit")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(select_recorded, m3500, "m3500")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(select_recorded, csail, "csail")->Unit(benchmark::kMillisecond);

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
