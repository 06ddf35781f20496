// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/evaluation/vehicle_knowledge.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/localization/map_format.hpp"
#include "falko_slam/ros_bridge/simulation_bag.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "output_files.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct SimulateOptions {
  std::string scenario;
  std::string out;
  std::string truth;
  std::string map;
  std::string calibration;
  double survey_noise = 0.0;
  SimulationBagParams params;
};

// What a calibration without errors would find.
StoredCalibration without_errors(const VehicleModel& vehicle) {
  StoredCalibration stored;
  stored.calibration = true_calibration(vehicle);
  const CalibrationVector values = vector_of(stored.calibration);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    stored.intervals[i] = {values[static_cast<int>(i)], values[static_cast<int>(i)]};
  }
  return stored;
}

void simulate(const SimulateOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  require_new(options.out, options.params.replace);
  const Scenario scenario = read_scenario(options.scenario);
  if (!options.map.empty()) {
    std::mt19937_64 random(options.params.seed);
    write_map_of_any_format(options.map,
                            surveyed_map(scenario.world, options.survey_noise, random));
  }
  if (!options.calibration.empty()) {
    write_calibration(options.calibration, without_errors(scenario.vehicle));
  }
  Progress progress("scans");
  const SimulationBagReport report =
      simulate_to_bag(scenario, options.params, options.out, [&] { progress.step(); });
  if (!options.truth.empty()) write_tum(options.truth, report.truth);
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cout << report.scans << " scans of " << scenario.laser.beams << " beams, " << report.seconds
            << " s of " << report.drive << ", " << std::round(report.seconds / wall)
            << " times real time\n"
            << "wrote " << options.out << ": " << describe_resources() << "\n";
}

}  // namespace

void add_simulate(CLI::App& app) {
  auto options = std::make_shared<SimulateOptions>();
  SimulationBagParams& params = options->params;
  CLI::App* verb = app.add_subcommand(
      "simulate", "a vehicle with a laser scanner in a world, and what it publishes as a bag");
  verb->add_option("scenario", options->scenario,
                   "YAML file, see doc/scenarios.md; those in config/scenarios for example")
      ->required();
  verb->add_option("--out", options->out, "bag to write")->required();
  verb->add_option("--truth", options->truth,
                   "file for the true trajectory, as `evaluate slam --truth` reads it");
  verb->add_option("--map-out", options->map,
                   "file for the world's reflectors, .yaml or .imk, as `localize --map` reads it");
  verb->add_option("--calibration-out", options->calibration,
                   "file for the vehicle's true parameters, as `localize --calibration` reads it");
  verb->add_option("--survey-noise", options->survey_noise,
                   "standard deviation of their coordinates in that file [m], default 0")
      ->check(number_in(0.0, 1.0));
  verb->add_option("--drive", params.drive_bag,
                   "bag with commands, encoders or joint states that drive the vehicle; default: "
                   "the scenario's drive");
  verb->add_option("--drive-topic", params.drive_topic, "of that bag; default: its only one");
  verb->add_option("--duration", params.duration,
                   "to simulate [s]; default: until the drive is over")
      ->check(number_in(0.01, 1e6));
  verb->add_option("--seed", params.seed, "of all noise, default 1")->check(CLI::NonNegativeNumber);
  verb->add_option("--world-frame", params.frames.world, "of the truth, default world");
  verb->add_option("--odom-frame", params.frames.odom, "default odom");
  verb->add_option("--base-frame", params.frames.base, "default base_link");
  verb->add_option("--laser-frame", params.frames.laser, "default laser");
  verb->add_flag("--force", params.replace, "replace an existing bag");
  verb->callback([options] { simulate(*options); });
}

}  // namespace cli
}  // namespace falko_slam
