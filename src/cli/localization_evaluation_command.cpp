// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iomanip>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "commands.hpp"
#include "console.hpp"
#include "falko_slam/evaluation/mrclam_evaluation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "simulated_localization.hpp"

namespace falko_slam {
namespace cli {
namespace {

struct EvaluateLocalizationOptions {
  std::string mrclam;
  std::vector<int> robots = {1, 3};
  bool without_ids = false;
  MrclamParams params;
  std::string json;
  SimulatedLocalizationOptions simulated;
  bool no_deskew = false;
};

void print_report(int robot, const MrclamRun& run, const MrclamEvaluation& e) {
  const auto degrees = [](double radians) { return radians_to_degrees(radians); };
  std::cout << "robot " << robot << ": " << run.odometry.size() << " commands, "
            << run.measurements.size() << " observations of " << run.landmarks.size()
            << " landmarks (" << run.other_measurements << " others left out)\n"
            << std::fixed << std::setprecision(3)  //
            << "             RMSE [m]   [deg]\n"
            << "  filter     " << std::setw(8) << e.filter.position << std::setw(8)
            << std::setprecision(2) << degrees(e.filter.heading) << "   median "
            << std::setprecision(3) << e.median_position << " m " << std::setprecision(2)
            << degrees(e.median_heading) << " deg\n"
            << "  odometry   " << std::setprecision(3) << std::setw(8) << e.odometry.position
            << std::setprecision(2) << std::setw(8) << degrees(e.odometry.heading) << "\n"
            << "  used " << e.used << " of " << e.observations << " observations, " << e.wrong
            << " wrongly\n"
            << "  NIS per degree " << e.mean_nis << ", " << 100.0 * e.nis_inside
            << " % of updates within 95 % bounds\n"
            << "  NEES per degree " << e.mean_nees << ", median " << e.median_nees
            << " (ideal 0.79), " << 100.0 * e.nees_inside << " % within 95 % bounds\n"
            << std::defaultfloat << std::setprecision(6);
}

nlohmann::json json_of(int robot, const MrclamEvaluation& e) {
  const auto rmse = [](const PoseRmse& of) {
    return nlohmann::json{{"position", of.position}, {"heading", of.heading}};
  };
  return {{"robot", robot},
          {"filter_rmse", rmse(e.filter)},
          {"odometry_rmse", rmse(e.odometry)},
          {"median_position", e.median_position},
          {"median_heading", e.median_heading},
          {"observations", e.observations},
          {"used", e.used},
          {"wrong", e.wrong},
          {"mean_nis", e.mean_nis},
          {"nis_inside", e.nis_inside},
          {"mean_nees", e.mean_nees},
          {"median_nees", e.median_nees},
          {"nees_inside", e.nees_inside}};
}

void evaluate_mrclam_runs(EvaluateLocalizationOptions& options) {
  options.params.use_ids = !options.without_ids;
  nlohmann::json document = nlohmann::json::array();
  for (const int robot : options.robots) {
    const MrclamRun run = read_mrclam(options.mrclam, robot);
    const MrclamEvaluation evaluation = evaluate_mrclam(run, options.params);
    print_report(robot, run, evaluation);
    document.push_back(json_of(robot, evaluation));
  }
  std::cout << describe_resources() << "\n";
  if (!options.json.empty()) write_json(options.json, document);
}

void add_noise(CLI::App* verb, MrclamParams& params) {
  const auto add = [&](const char* name, double& value, const char* what, double least) {
    verb->add_option(name, value, what)->check(number_in(least, 10.0))->capture_default_str();
  };
  add("--way-noise", params.way_noise, "of the way [m / sqrt(m)]", 0.0);
  add("--turn-noise", params.turn_noise, "of the turn [rad / sqrt(rad)]", 0.0);
  add("--heading-drift", params.heading_drift, "while it moves [rad / sqrt(s)]", 0.0);
  add("--turn-scale", params.turn_scale, "true turn over commanded turn", 1e-3);
  add("--range-noise", params.range_noise, "[m]", 1e-6);
  add("--bearing-noise", params.bearing_noise, "[rad]", 1e-6);
  verb->add_option("--correlation-time", params.correlation_time,
                   "of the errors of one landmark's observations [s], default 0: none")
      ->check(number_in(0.0, 1000.0));
}

void add_simulated(CLI::App* verb, EvaluateLocalizationOptions& options) {
  SimulatedLocalizationOptions& simulated = options.simulated;
  verb->add_option("scenario", simulated.scenario, "YAML file, see doc/scenarios.md");
  verb->add_option("--seeds", simulated.seeds, "of the drives, default 1,2,3,4,5,6")
      ->delimiter(',')
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--duration", simulated.duration, "of each drive at most [s]")
      ->check(number_in(1.0, 1e6));
  verb->add_option("--survey-noise", simulated.survey_noise,
                   "of the map's reflectors [m], default 0")
      ->check(number_in(0.0, 1.0));
  verb->add_option("--slip", simulated.odometry.slip,
                   "what the localizer takes for the slip of the wheel [m / sqrt(m)]")
      ->check(number_in(0.0, 1.0));
  verb->add_option("--steer", simulated.odometry.steer, "the same of the steering [rad sqrt(m)]")
      ->check(number_in(0.0, 1.0));
  verb->add_option("--map", simulated.map,
                   "YAML file of landmarks; default: the scenario's reflectors");
  verb->add_flag("--perfect-calibration", simulated.perfect_calibration,
                 "the vehicle is what it is taken for");
  verb->add_flag("--no-deskew", options.no_deskew, "scans are taken for instants");
  verb->add_option("--kidnap", simulated.kidnaps,
                   "carries the vehicle from the drive of the first seed to that of the last so "
                   "many times")
      ->check(CLI::Range(0, 100000));
  verb->add_flag("--paths", simulated.paths,
                 "the named paths of the drive, reflectors hidden: with landmarks in the state, "
                 "with Algorithm 1, with odometry");
  verb->add_option("--scatter", simulated.variation.scatter,
                   "the world's things are scattered so many times as much")
      ->check(number_in(0.0, 100.0));
  verb->add_option("--bulge", simulated.variation.bulge, "they bulge so many times as much")
      ->check(number_in(0.0, 100.0));
  verb->add_option("--scatter-seed", simulated.variation.scatter_seed, "they stand otherwise");
  verb->add_option("--parameters", simulated.parameters,
                   "YAML file with parameters of the localizer");
}

void evaluate_localization(EvaluateLocalizationOptions& options) {
  if (options.mrclam.empty() == options.simulated.scenario.empty()) {
    throw std::runtime_error("evaluate localization: either a scenario or --mrclam");
  }
  if (!options.mrclam.empty()) return evaluate_mrclam_runs(options);
  options.simulated.localizer.deskew = !options.no_deskew;
  options.simulated.json = options.json;
  evaluate_simulated_localization(options.simulated);
}

}  // namespace

void add_evaluate_localization(CLI::App& evaluate) {
  auto options = std::make_shared<EvaluateLocalizationOptions>();
  CLI::App* verb = evaluate.add_subcommand(
      "localization",
      "the localizer on simulated drives, or the filter on the MRCLAM data, against true poses");
  add_simulated(verb, *options);
  verb->add_option(
      "--mrclam", options->mrclam,
      "a folder of the UTIAS MRCLAM data set: Robot<n>_Odometry.dat and so on, or .gz");
  verb->add_option("--robots", options->robots, "separated by commas, default 1,3")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000));
  verb->add_flag("--without-ids", options->without_ids,
                 "the filter finds out which landmark is which");
  add_noise(verb, options->params);
  verb->add_option("--json", options->json, "write all figures")->check(a_file());
  verb->callback([options] { evaluate_localization(*options); });
}

}  // namespace cli
}  // namespace falko_slam
