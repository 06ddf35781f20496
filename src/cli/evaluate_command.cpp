// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "commands.hpp"
#include "console.hpp"
#include "feature_report.hpp"
#include "loop_report.hpp"

namespace falko_slam {
namespace cli {
namespace {

template <class Params>
struct EvaluateOptions {
  std::vector<std::string> logs;
  std::string json;
  Params params;
};
using EvaluateFeaturesOptions = EvaluateOptions<FeatureEvaluationParams>;
using EvaluateLoopsOptions = EvaluateOptions<LoopEvaluationParams>;

void tell(const std::string& what) { std::cerr << what << " ...\n"; }

// Evaluates, prints the tables and returns the figures.
nlohmann::json evaluate(const std::vector<PosedScan>& scans,
                        const FeatureEvaluationParams& params) {
  const FeatureEvaluation evaluation = evaluate_features(scans, params, tell);
  print_report(evaluation, params);
  return as_json(evaluation, params);
}

nlohmann::json evaluate(const std::vector<PosedScan>& scans, const LoopEvaluationParams& params) {
  const LoopEvaluation evaluation = evaluate_loops(scans, params, tell);
  print_report(evaluation);
  return as_json(evaluation);
}

template <class Params>
void evaluate_logs(const EvaluateOptions<Params>& options) {
  nlohmann::json document = nlohmann::json::array();
  for (const std::string& log : options.logs) {
    CarmenReport report;
    const std::vector<PosedScan> scans = load_posed_scans(log, report);
    std::cout << log << ": " << describe(report) << "\n";
    nlohmann::json entry = evaluate(scans, options.params);
    std::cout << "\n" << std::flush;
    entry["log"] = log.substr(log.find_last_of('/') + 1);
    document.push_back(entry);
  }
  std::cout << describe_resources() << "\n";
  if (!options.json.empty()) write_json(options.json, document);
}

void add_features(CLI::App& evaluate) {
  auto options = std::make_shared<EvaluateFeaturesOptions>();
  RepeatabilityParams& conditions = options->params.repeatability;
  CLI::App* verb = evaluate.add_subcommand(
      "features", "Tables 3.1, 3.2 and Figs. 3.8, 3.9 of the thesis, on logs with corrected poses");
  verb->add_option("logs", options->logs,
                   "CARMEN logs: VERTEX2 before ROBOTLASER1, or FLASER with corrected poses")
      ->required();
  verb->add_option("--json", options->json, "write all figures; scripts/plot_features draws them")
      ->check(a_file());
  verb->add_option("--references", conditions.reference_scans,
                   "reference scans drawn at random, default 100")
      ->check(CLI::Range(1, 1000000));
  verb->add_option("--seed", conditions.seed, "default 1")->check(CLI::NonNegativeNumber);
  verb->add_option("--association-radius", conditions.association_radius,
                   "keypoints nearer than this are the same [m], default 0.1")
      ->check(number_in(0.001, 10.0));
  verb->add_option("--viewpoint-distance", conditions.viewpoint_distance,
                   "scans nearer than this are compared [m], default 1")
      ->check(number_in(0.001, 1000.0));
  verb->add_option("--map-separation", options->params.map_separation,
                   "d_min of Table 3.1 [m], default 0.2")
      ->check(number_in(0.0, 100.0));
  verb->add_option("--map-orders", options->params.map_orders,
                   "random orders of the scans that Table 3.1 is averaged over, default 10")
      ->check(CLI::Range(1, 1000));
  verb->callback([options] { evaluate_logs(*options); });
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

CLI::Validator loop_methods() {
  const auto check = [](const std::string& list) -> std::string {
    try {
      LoopEvaluationParams params;
      params.methods = split(list);
      validate(params);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  return {check, "NAME,..."};
}

void add_loops(CLI::App& evaluate) {
  auto options = std::make_shared<EvaluateLoopsOptions>();
  CLI::App* verb = evaluate.add_subcommand(
      "loops", "Fig. 4.2 and Table 4.1 of the thesis, on logs with corrected poses");
  verb->add_option("logs", options->logs,
                   "CARMEN logs: VERTEX2 before ROBOTLASER1, or FLASER with corrected poses")
      ->required();
  verb->add_option("--json", options->json, "write all figures; scripts/plot_loops draws them")
      ->check(a_file());
  std::string names;
  for (const std::string& name : loop_method_names())
    names.append(names.empty() ? "" : ",").append(name);
  auto methods = std::make_shared<std::string>();
  verb->add_option("--methods", *methods, "which ones, separated by commas, default " + names)
      ->check(loop_methods());
  verb->add_option("--candidates", options->params.thesis.candidates,
                   "nearest signatures that the thesis' methods associate, default 10; GFP: 50")
      ->check(CLI::Range(1, 1000));
  auto grid = std::make_shared<bool>(false);
  verb->add_flag(
      "--grid-normals", *grid,
      "GSR takes normals from a grid, as in the thesis, not the keypoints' orientations");
  verb->add_option("--seed", options->params.thesis.seed, "of RANSAC, default 1")
      ->check(CLI::NonNegativeNumber);
  verb->callback([options, methods, grid] {
    if (!methods->empty()) options->params.methods = split(*methods);
    if (*grid) options->params.thesis.normals = KeypointNormals::kGrid;
    evaluate_logs(*options);
  });
}

struct EvaluateDriveOptions {
  std::string raw;
  std::string corrected;
  std::string json;
};

void evaluate_drive_log(const EvaluateDriveOptions& options) {
  CarmenReport report;
  const auto scans = load_driven_scans(options.raw, options.corrected, report);
  std::cout << options.raw << ": " << describe(report) << "\n" << std::flush;
  std::vector<DriveResult> results;
  for (const DrivePoses poses :
       {DrivePoses::kCorrected, DrivePoses::kOdometry, DrivePoses::kRegistered}) {
    tell(name_of(poses));
    results.push_back(evaluate_drive(scans, poses));
  }
  print_report(results);
  std::cout << describe_resources() << "\n";
  if (!options.json.empty()) write_json(options.json, as_json(results));
}

void add_drive(CLI::App& evaluate) {
  auto options = std::make_shared<EvaluateDriveOptions>();
  CLI::App* verb = evaluate.add_subcommand(
      "drive", "loop closure as the nodelet does it, with the odometry of a raw log");
  verb->add_option("raw", options->raw, "CARMEN log with scans and odometry")->required();
  verb->add_option("corrected", options->corrected,
                   "CARMEN log of the same drive: VERTEX2 before ROBOTLASER1, the same stamps")
      ->required();
  verb->add_option("--json", options->json, "write all figures")->check(a_file());
  verb->callback([options] { evaluate_drive_log(*options); });
}

}  // namespace

void add_evaluate(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("evaluate", "measure against ground truth");
  verb->require_subcommand(1);
  add_features(*verb);
  add_loops(*verb);
  add_drive(*verb);
  add_evaluate_precision(*verb);
  add_evaluate_reflectors(*verb);
  add_evaluate_slam(*verb);
  add_evaluate_soak(*verb);
  add_evaluate_calibration(*verb);
  add_evaluate_localization(*verb);
}

}  // namespace cli
}  // namespace falko_slam
