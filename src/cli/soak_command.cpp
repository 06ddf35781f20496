// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <random>
#include <stdexcept>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/evaluation/soak.hpp"
#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/laser_scanner.hpp"
#include "falko_slam/simulation/scenario_file.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct SoakOptions {
  std::string scenario, layout, json;
  double survey_noise = 0.002;
  SoakParams params;
};

void print_period(const SoakPeriod& period, double memory) {
  std::printf("%5.1f %6zu %6.2f %7.2f %7.1f %7.3f %6zu %6.1f %6.1f %7.2f %7.1f %5zu %7.1f\n",
              period.begin / 3600.0, period.scans,
              100.0 * static_cast<double>(period.ok) / static_cast<double>(period.scans),
              1e3 * period.position_rmse, 1e3 * period.position_max,
              radians_to_degrees(period.heading_rmse), period.halts, 1e3 * period.halt_mean,
              1e3 * period.halt_max, 1e3 * period.mean_time, 1e3 * period.max_time, period.late,
              1e-6 * memory);
  std::fflush(stdout);
}

nlohmann::json json_of(const SoakPeriod& period, double memory) {
  return {{"begin", period.begin},
          {"end", period.end},
          {"scans", period.scans},
          {"ok", period.ok},
          {"posed", period.posed},
          {"position_rmse", period.position_rmse},
          {"position_max", period.position_max},
          {"heading_rmse", period.heading_rmse},
          {"mean_time", period.mean_time},
          {"max_time", period.max_time},
          {"late", period.late},
          {"halts", period.halts},
          {"halt_mean", period.halt_mean},
          {"halt_max", period.halt_max},
          {"memory", memory}};
}

void run_soak(SoakOptions& options) {
  const Scenario scenario = read_scenario(options.scenario);
  const Layout layout = read_layout(options.layout);
  options.params.localizer.reflectors.diameter = diameter_of_reflectors(scenario.world);
  std::mt19937_64 random(options.params.seed);
  const LandmarkMap map = surveyed_map(scenario.world, options.survey_noise, random);
  std::printf("%s, %s: %.1f hours\n", options.scenario.c_str(), options.layout.c_str(),
              options.params.hours);
  std::printf(
      " from  scans     OK    RMSE     max    RMSE  halts   mean  worst    mean longest  late  "
      "memory\n"
      "  [h]            [%%]    [mm]    [mm]   [deg]          [mm]   [mm]    [ms]    [ms]        "
      "[MB]\n");
  nlohmann::json periods = nlohmann::json::array();
  const std::string trouble =
      soak(scenario, layout, map, options.params, [&](const SoakPeriod& period) {
        const double memory = resident_memory();
        print_period(period, memory);
        periods.push_back(json_of(period, memory));
      });
  std::printf("%s\n", describe_resources().c_str());
  if (!options.json.empty()) write_json(options.json, periods);
  if (!trouble.empty()) throw std::runtime_error("the vehicle did not come through: " + trouble);
}

}  // namespace

void add_evaluate_soak(CLI::App& evaluate) {
  auto options = std::make_shared<SoakOptions>();
  CLI::App* verb = evaluate.add_subcommand(
      "soak", "a vehicle drives a layout over and over: errors, times and memory by the hour");
  verb->add_option("scenario", options->scenario, "YAML file of the plant, see doc/scenarios.md")
      ->required();
  verb->add_option("layout", options->layout, "YAML file of the paths, in the plant's frame")
      ->required();
  verb->add_option("--hours", options->params.hours, "of the vehicle's time")
      ->check(number_in(1e-3, 1e4))
      ->capture_default_str();
  verb->add_option("--period", options->params.period_minutes, "of each line [min]")
      ->check(number_in(1e-2, 1e4))
      ->capture_default_str();
  verb->add_option("--survey-noise", options->survey_noise, "of the map's reflectors [m]")
      ->check(number_in(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--seed", options->params.seed, "of all noise, default 1")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--json", options->json, "write all figures; scripts/plot_soak draws them")
      ->check(a_file());
  verb->callback([options] { run_soak(*options); });
}

}  // namespace cli
}  // namespace falko_slam
