// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <random>
#include <stdexcept>
#include <thread>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/calibration/monte_carlo.hpp"
#include "falko_slam/common/parallel_work.hpp"
#include "falko_slam/evaluation/precision_evaluation.hpp"
#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/simulation/laser_scanner.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "precision_report.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct EvaluatePrecisionOptions {
  std::string scenario, layout, json;
  std::uint64_t seed = 1;
  int rounds = 1;
  double survey_noise = 0.002;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

PrecisionParams params_of(const EvaluatePrecisionOptions& options, const World& world) {
  PrecisionParams params;
  const SimulatedCalibrationNoise usual;
  params.calibration.vehicle.errors.slip_per_run = usual.slip;
  params.calibration.vehicle.errors.steering_per_run = usual.steer;
  params.localizer.reflectors.diameter = diameter_of_reflectors(world);
  params.seed = options.seed;
  params.rounds = options.rounds;
  return params;
}

void evaluate_precision(const EvaluatePrecisionOptions& options) {
  const Scenario plant = read_scenario(options.scenario);
  const Layout layout = read_layout(options.layout);
  const PrecisionParams params = params_of(options, plant.world);
  std::mt19937_64 random(options.seed);
  const LandmarkMap map = surveyed_map(plant.world, options.survey_noise, random);
  const std::vector<PrecisionVehicle> vehicles = thesis_vehicles();
  std::vector<PrecisionRun> runs(vehicles.size());
  do_in_parallel(runs.size(), static_cast<std::size_t>(options.threads), [&](std::size_t i) {
    runs[i] = falko_slam::evaluate_precision(vehicles[i], i, plant, layout, map, params);
  });
  std::printf("%s, %s: %d round%s, survey noise %.1f mm, seed %llu\n", options.scenario.c_str(),
              options.layout.c_str(), options.rounds, options.rounds > 1 ? "s" : "",
              1e3 * options.survey_noise, static_cast<unsigned long long>(options.seed));
  print_precision(runs);
  std::printf("%s\n", describe_resources().c_str());
  if (!options.json.empty()) write_json(options.json, as_json(runs));
}

}  // namespace

void add_evaluate_precision(CLI::App& evaluate) {
  auto options = std::make_shared<EvaluatePrecisionOptions>();
  CLI::App* verb = evaluate.add_subcommand("precision",
                                           "Section 5.2.2 of the thesis: where vehicles halt that "
                                           "were calibrated, and one that was not");
  verb->add_option("scenario", options->scenario, "YAML file of the plant, see doc/scenarios.md")
      ->required();
  verb->add_option("layout", options->layout, "YAML file of the paths, in the plant's frame")
      ->required();
  verb->add_option("--rounds", options->rounds, "each vehicle drives the layout so many times")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb->add_option("--survey-noise", options->survey_noise,
                   "of the map's reflectors, which all vehicles share [m]")
      ->check(number_in(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--seed", options->seed, "of all noise, default 1")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--threads", options->threads, "of no influence on the figures, default all")
      ->check(CLI::Range(1, 256));
  verb->add_option("--json", options->json,
                   "write all figures; scripts/plot_precision draws Fig. 5.6")
      ->check(a_file());
  verb->callback([options] { evaluate_precision(*options); });
}

}  // namespace cli
}  // namespace falko_slam
