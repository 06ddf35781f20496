// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "calibration_report.hpp"
#include "commands.hpp"
#include "console.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct EvaluateCalibrationOptions {
  std::vector<std::size_t> conditions;
  std::string model = "asymmetric";
  bool known_noise = false;
  bool simulated = false;
  std::optional<int> runs, scans_at_rest;
  std::uint64_t seed = 1;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  SimulatedCalibrationNoise noise;  // of both simulations
  std::string json;
};

TricycleModel model_of(const EvaluateCalibrationOptions& options) {
  return options.model == "standard" ? TricycleModel::kStandard : TricycleModel::kAsymmetric;
}

CalibratorParams calibrator_of(const EvaluateCalibrationOptions& options, double wheelbase) {
  CalibratorParams params;
  params.model = model_of(options);
  params.wheelbase = wheelbase;
  if (options.known_noise) {
    params.noise.slip = options.noise.slip;
    params.noise.steer = options.noise.steer;
    params.noise.common_slip = params.noise.common_steer = 0.0;
    params.noise.unknown_factor = 1.0;
  }
  return params;
}

// What the standard model takes for granted.
void take_one_offset(TricycleParams& tricycle) {
  const double offset = 0.5 * (tricycle.steer_offset_forward + tricycle.steer_offset_backward);
  tricycle.steer_offset_forward = tricycle.steer_offset_backward = offset;
}

MonteCarloParams monte_carlo_of(const EvaluateCalibrationOptions& options) {
  MonteCarloParams params;
  if (model_of(options) == TricycleModel::kStandard) take_one_offset(params.truth.tricycle);
  params.noise = options.noise;
  params.noise.scans_at_rest = options.scans_at_rest.value_or(params.noise.scans_at_rest);
  params.calibrator = calibrator_of(options, params.truth.tricycle.wheelbase);
  if (params.noise.viewpoint_bias > 0.0) {
    params.calibrator.noise = told_of_viewpoint_bias(params.calibrator.noise, params.noise);
  }
  params.runs = options.runs.value_or(params.runs);
  params.seed = options.seed;
  params.threads = options.threads;
  return params;
}

SimulatedCalibrationParams simulated_of(const EvaluateCalibrationOptions& options) {
  SimulatedCalibrationParams params;
  if (model_of(options) == TricycleModel::kStandard) take_one_offset(params.vehicle.tricycle);
  params.vehicle.errors.slip_per_run = options.noise.slip;
  params.vehicle.errors.steering_per_run = options.noise.steer;
  params.vehicle.errors.slip_per_phase = options.noise.common_slip;
  params.vehicle.errors.steering_per_phase = options.noise.common_steer;
  params.calibrator = calibrator_of(options, params.vehicle.tricycle.wheelbase);
  params.scans_at_rest = options.scans_at_rest.value_or(params.scans_at_rest);
  params.runs = options.runs.value_or(params.runs);
  params.seed = options.seed;
  params.threads = options.threads;
  return params;
}

void evaluate_calibration(const EvaluateCalibrationOptions& options) {
  const auto numbers = options.conditions.empty() ? all_condition_numbers() : options.conditions;
  const auto tell = [](std::size_t number) { std::cerr << "condition " << number << " ...\n"; };
  const CalibrationStudy study = options.simulated
                                     ? study_calibration(numbers, simulated_of(options), tell)
                                     : study_calibration(numbers, monte_carlo_of(options), tell);
  print_report(study);
  if (!options.simulated) {
    std::cout << "Speeds do not enter: rows that differ in v_w alone differ by chance.\n";
  }
  std::cout << describe_resources() << "\n";
  if (options.json.empty()) return;
  nlohmann::json document = as_json(study);
  document["simulated"] = options.simulated;
  document["known_noise"] = options.known_noise;
  document["seed"] = options.seed;
  write_json(options.json, document);
}

void add_noise_options(CLI::App* verb, EvaluateCalibrationOptions& options) {
  SimulatedCalibrationNoise& noise = options.noise;
  verb->add_option("--slip", noise.slip, "deviation of an arc's slip, as a share of its way")
      ->check(number_in(0.0, 0.1))
      ->capture_default_str();
  verb->add_option("--steer-noise", noise.steer, "deviation of an arc's steering error [rad]")
      ->check(number_in(0.0, 0.1))
      ->capture_default_str();
  verb->add_option("--common-slip", noise.common_slip,
                   "deviation of the slip that the arcs of a phase have in common, default 0")
      ->check(number_in(0.0, 0.1));
  verb->add_option("--common-steer", noise.common_steer,
                   "the same of the steering error [rad], default 0")
      ->check(number_in(0.0, 0.1));
  verb->add_option("--scans-at-rest", options.scans_at_rest,
                   "that are averaged at each end of an arc, default 1; simulated: at least so "
                   "many, default 20")
      ->check(CLI::Range(1, 200));
  verb->add_option("--detection-noise", noise.detection,
                   "deviation of a reflector's coordinates in a scan [m]")
      ->check(number_in(1e-9, 1.0))
      ->capture_default_str()
      ->excludes("--simulated");
  verb->add_option("--viewpoint-bias", noise.viewpoint_bias,
                   "by which a reflector looks displaced, depending on from where; the calibrator "
                   "knows it [m], default 0")
      ->check(number_in(0.0, 1.0))
      ->excludes("--simulated");
}

}  // namespace

void add_evaluate_calibration(CLI::App& evaluate) {
  auto options = std::make_shared<EvaluateCalibrationOptions>();
  CLI::App* verb = evaluate.add_subcommand(
      "calibration",
      "Tables 5.1 and 5.2 of the thesis: simulated calibrations of a CB16 under their conditions");
  verb->add_option("--conditions", options->conditions,
                   "numbers of rows of the tables, from 1, separated by commas, default all")
      ->delimiter(',')
      ->check(CLI::Range(std::size_t{1}, thesis_conditions().size()));
  verb->add_option("--runs", options->runs,
                   "calibrations under each condition, default 400; simulated: 20")
      ->check(CLI::Range(2, 1000000));
  verb->add_option("--seed", options->seed, "default 1")->check(CLI::NonNegativeNumber);
  verb->add_option("--model", options->model,
                   "of calibrator and vehicle: asymmetric, or standard with one steer offset")
      ->check(CLI::IsMember({"asymmetric", "standard"}))
      ->capture_default_str();
  verb->add_flag(
      "--known-noise", options->known_noise,
      "the calibrator knows slip and steer noise, and that phases have nothing in common");
  verb->add_flag("--simulated", options->simulated,
                 "drives in the complete simulator, each in a random hall; speeds count");
  add_noise_options(verb, *options);
  verb->add_option("--threads", options->threads, "of no influence on the figures, default all")
      ->check(CLI::Range(1, 256));
  verb->add_option("--json", options->json,
                   "write all figures; scripts/plot_calibration draws them")
      ->check(a_file());
  verb->callback([options] { evaluate_calibration(*options); });
}

}  // namespace cli
}  // namespace falko_slam
