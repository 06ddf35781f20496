// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <malloc.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/pose_graph/consistency.hpp"
#include "falko_slam/pose_graph/g2o_file.hpp"
#include "falko_slam/pose_graph/initial_guess.hpp"
#include "falko_slam/pose_graph/optimizer.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct OptimizeOptions {
  std::string in, out, json;
  Guess guess = Guess::kBetter;
  bool select = false;
  OptimizerParams params;
};

const std::map<std::string, Guess> kGuesses{
    {"given", Guess::kGiven}, {"computed", Guess::kComputed}, {"auto", Guess::kBetter}};
const std::map<std::string, Loss> kLosses{
    {"none", Loss::kNone}, {"huber", Loss::kHuber}, {"cauchy", Loss::kCauchy}};

struct Result {
  GuessedGraph guess;
  OptimizationSummary summary;
  double given_chi2 = 0.0;
  double guess_milliseconds = 0.0, solve_milliseconds = 0.0;
  std::map<std::string, std::size_t> verdicts;  // of closures; empty if none was asked for
};

// Milliseconds since the last call.
class StopWatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> time = now - last_;
    last_ = now;
    return time.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Leaves the accepted closures only.
void select(PoseGraph& graph, std::map<std::string, std::size_t>& counts) {
  const std::vector<ClosureVerdict> verdicts = select_closures(graph);
  std::vector<GraphConstraint> kept;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (graph.constraints[i].kind == ConstraintKind::kClosure) ++counts[name_of(verdicts[i])];
    if (verdicts[i] == ClosureVerdict::kAccepted) kept.push_back(graph.constraints[i]);
  }
  graph.constraints = kept;
}

Result solve(PoseGraph graph, const OptimizeOptions& options) {
  Result result;
  if (options.select) select(graph, result.verdicts);
  require_connected(graph);
  result.given_chi2 = chi2_of(graph);
  StopWatch watch;
  result.guess = guess_poses(graph, options.guess);
  result.guess_milliseconds = watch.lap();
  PoseGraphOptimizer optimizer(result.guess.graph, options.params);
  result.summary = optimizer.optimize();
  result.solve_milliseconds = watch.lap();
  result.guess.graph = optimizer.graph();
  return result;
}

void print(const G2oFile& file, const Result& result) {
  const OptimizationSummary& summary = result.summary;
  std::printf("%zu nodes, %zu edges\n", result.guess.graph.nodes.size(),
              result.guess.graph.constraints.size());
  for (const auto& [tag, count] : file.unknown_tags) {
    std::printf("%zu lines left out that begin with %s\n", count, tag.c_str());
  }
  for (const auto& [verdict, count] : result.verdicts) {
    std::printf("%zu closures %s\n", count, verdict.c_str());
  }
  if (file.has_poses) std::printf("chi2 of the poses given:   %.3f\n", result.given_chi2);
  std::printf("chi2 of the poses started from: %.3f, %s\n", summary.initial_chi2,
              result.guess.computed ? "computed from the edges" : "the poses given");
  std::printf("chi2 of the optimised poses: %.3f\n", summary.final_chi2);
  std::printf("%d iterations, %s\n", summary.iterations,
              summary.converged ? "converged" : "not converged");
  std::printf("guess %.1f ms, solve %.1f ms\n", result.guess_milliseconds,
              result.solve_milliseconds);
}

nlohmann::json json_of(const G2oFile& file, const Result& result) {
  const OptimizationSummary& summary = result.summary;
  nlohmann::json document{{"nodes", result.guess.graph.nodes.size()},
                          {"edges", result.guess.graph.constraints.size()},
                          {"computed_guess", result.guess.computed},
                          {"start_chi2", summary.initial_chi2},
                          {"chi2", summary.final_chi2},
                          {"cost", summary.final_cost},
                          {"iterations", summary.iterations},
                          {"converged", summary.converged},
                          {"message", summary.message},
                          {"guess_ms", result.guess_milliseconds},
                          {"solve_ms", result.solve_milliseconds},
                          {"lines_left_out", file.unknown_tags}};
  if (file.has_poses) document["given_chi2"] = result.given_chi2;
  if (!result.verdicts.empty()) document["closures"] = result.verdicts;
  return document;
}

// Keeps what is freed: asking the system for it again was up to a third of the time of a solve.
void keep_memory() {
#ifdef __GLIBC__
  constexpr int kBytes = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, kBytes);
  mallopt(M_TRIM_THRESHOLD, kBytes);
  mallopt(M_TOP_PAD, 1 << 24);
#endif
}

void optimize(OptimizeOptions options) {
  keep_memory();
  const G2oFile file = read_g2o(options.in);
  if (!file.has_poses) {
    if (options.guess == Guess::kGiven) {
      throw std::invalid_argument(options.in + ": holds no poses to start from: --guess computed");
    }
    options.guess = Guess::kComputed;
  }
  const Result result = solve(file.graph, options);
  write_g2o(options.out, result.guess.graph);
  if (options.json != "-") {
    print(file, result);
    std::printf("%s\n", describe_resources().c_str());
  }
  if (!options.json.empty()) write_json(options.json, json_of(file, result));
}

}  // namespace

void add_optimize(CLI::App& app) {
  auto options = std::make_shared<OptimizeOptions>();
  options->params.closure_loss = Loss::kNone;
  CLI::App* verb = app.add_subcommand("optimize", "the most likely poses of a pose graph");
  verb->add_option("in", options->in, "g2o or TORO file of a planar graph (.gz, .bz2)")->required();
  verb->add_option("out", options->out, "g2o file to write (.gz, .bz2)")->required();
  verb->add_option("--guess", options->guess,
                   "start from the poses given, from poses computed from the edges, or from the "
                   "better ones: given, computed, auto (default)")
      ->transform(CLI::CheckedTransformer(kGuesses));
  verb->add_option("--robust", options->params.closure_loss,
                   "loss of the edges that are no odometry: none (default), huber, cauchy")
      ->transform(CLI::CheckedTransformer(kLosses));
  verb->add_option("--loss-scale", options->params.loss_scale, "of it, in standard deviations")
      ->check(number_in(0.01, 1000.0));
  verb->add_option("--iterations", options->params.max_iterations, "at most")
      ->check(CLI::Range(1, 10000));
  verb->add_flag("--select-consistent", options->select,
                 "leave out edges that contradict odometry or each other");
  verb->add_option("--json", options->json, "write the figures; - for the console");
  verb->callback([options] { optimize(*options); });
}

}  // namespace cli
}  // namespace falko_slam
