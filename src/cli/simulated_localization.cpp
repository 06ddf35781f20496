// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_localization.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <random>

#include "console.hpp"
#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "falko_slam/localization/localizer_fields.hpp"
#include "falko_slam/simulation/laser_scanner.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "path_report.hpp"

namespace falko_slam {
namespace cli {
using Options = SimulatedLocalizationOptions;

LocalizerParams parameters_of(const Options& options, const World& world) {
  LocalizerParams params = options.localizer;
  params.reflectors.diameter = diameter_of_reflectors(world);
  if (options.parameters.empty()) return params;
  YamlFields file(options.parameters);
  visit_localizer_fields(params, file);
  file.check([&] { validate(params); });
  return params;
}

SimulatedDrive drive_of(const Options& options, const Scenario& scenario, std::uint64_t seed) {
  CalibrationSpread spread;
  if (options.perfect_calibration) spread = {0.0, 0.0, 0.0, 0.0, 0.0};
  Progress progress("scans");
  return simulate_drive(scenario, spread, options.odometry, seed, options.duration,
                        [&] { progress.step(); });
}

LandmarkMap map_of(const Options& options, const World& world, std::uint64_t seed) {
  if (!options.map.empty()) return read_landmark_map(options.map);
  std::mt19937_64 random(seed);
  return surveyed_map(world, options.survey_noise, random);
}

namespace {

double share(std::size_t count, std::size_t all) {
  return 100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, all));
}

void print_run(std::uint64_t seed, const LocalizationRun& run) {
  std::printf(
      "%6llu %6zu %7.2f %7.2f %7.3f %7.3f %6.2f %6.2f %6.2f %6.2f %6.2f %6.1f %5.1f %5.1f %5zu "
      "%6.2f %6.2f\n",
      static_cast<unsigned long long>(seed), run.scans, 1e3 * run.position_rmse,
      1e3 * run.position_max, radians_to_degrees(run.heading_rmse),
      radians_to_degrees(run.heading_max), 1e3 * run.position_bias_x, 1e3 * run.position_bias_y,
      run.nees, run.nis, run.landmarks, share(run.status[0], run.scans),
      share(run.status[1], run.scans), share(run.status[2] + run.status[3], run.scans),
      run.wrong_ok, 1e3 * run.mean_time, 1e3 * run.max_time);
}

// Why it was not kOk, in shares of all scans.
void print_reasons(const LocalizationRun& run) {
  std::printf("       ");
  for (std::size_t i = 1; i < kLocalizationReasonCount; ++i) {
    if (run.reasons[i] == 0) continue;
    std::printf(" %s %.1f %%", name_of(static_cast<LocalizationReason>(i)),
                share(run.reasons[i], run.scans));
  }
  std::printf("\n");
}

nlohmann::json json_of(std::uint64_t seed, const LocalizationRun& run) {
  return {{"seed", seed},
          {"scans", run.scans},
          {"posed", run.posed},
          {"position_rmse", run.position_rmse},
          {"position_max", run.position_max},
          {"heading_rmse", run.heading_rmse},
          {"heading_max", run.heading_max},
          {"nees", run.nees},
          {"nis", run.nis},
          {"landmarks", run.landmarks},
          {"scans_by_status", run.status},
          {"wrong_ok", run.wrong_ok},
          {"mean_time", run.mean_time},
          {"max_time", run.max_time}};
}

nlohmann::json evaluate_drives(const Options& options, const Scenario& scenario) {
  const LocalizerParams params = parameters_of(options, scenario.world);
  std::printf("%s, de-skew %s, survey noise %.1f mm\n", options.scenario.c_str(),
              params.deskew ? "on" : "off", 1e3 * options.survey_noise);
  std::printf(
      "  seed  scans    RMSE     max    RMSE     max  ahead   left   NEES    NIS  refl.     ok "
      "degr.  none wrong   mean    max\n"
      "                 [mm]    [mm]   [deg]   [deg]   [mm]   [mm]         per scan    [%%]   "
      "[%%]   [%%]    ok   [ms]   [ms]\n");
  nlohmann::json runs = nlohmann::json::array();
  for (const std::uint64_t seed : options.seeds) {
    const SimulatedDrive drive = drive_of(options, scenario, seed);
    const LocalizationRun run =
        evaluate_localization(drive, params, map_of(options, scenario.world, seed));
    print_run(seed, run);
    print_reasons(run);
    std::fflush(stdout);
    runs.push_back(json_of(seed, run));
  }
  return runs;
}

// One line: how many within the limit, the median and the worst.
void print_delays(const char* what, const std::vector<Kidnap>& kidnaps, double Kidnap::*delay,
                  double limit) {
  std::vector<double> delays;
  for (const Kidnap& kidnap : kidnaps) {
    if (kidnap.*delay >= 0.0) delays.push_back(kidnap.*delay);
  }
  std::sort(delays.begin(), delays.end());
  const auto within = std::upper_bound(delays.begin(), delays.end(), limit) - delays.begin();
  std::printf("  %-28s %3zu of %zu, %td within %.0f s", what, delays.size(), kidnaps.size(), within,
              limit);
  if (!delays.empty()) {
    std::printf(", median %.2f s, worst %.2f s", delays[delays.size() / 2], delays.back());
  }
  std::printf("\n");
}

nlohmann::json json_of(const Kidnap& kidnap) {
  const auto pose = [](const Pose2& of) { return nlohmann::json{of.x(), of.y(), of.theta()}; };
  return {{"from", pose(kidnap.from)},
          {"to", pose(kidnap.to)},
          {"ok_until", kidnap.ok_until},
          {"lost", kidnap.lost},
          {"three", kidnap.three},
          {"pose", kidnap.pose},
          {"ok", kidnap.ok},
          {"wrong_ok", kidnap.wrong_ok},
          {"wrong_posed", kidnap.wrong_posed}};
}

nlohmann::json evaluate_kidnapping(const Options& options, const Scenario& scenario) {
  const LocalizerParams params = parameters_of(options, scenario.world);
  const SimulatedDrive first = drive_of(options, scenario, options.seeds.front());
  const SimulatedDrive second = drive_of(options, scenario, options.seeds.back());
  KidnapParams kidnap;
  kidnap.count = options.kidnaps;
  kidnap.seed = options.seeds.front();
  const std::vector<Kidnap> kidnaps = evaluate_kidnaps(
      first, second, params, map_of(options, scenario.world, options.seeds.front()), kidnap);
  std::size_t wrong_ok = 0, wrong_posed = 0;
  nlohmann::json list = nlohmann::json::array();
  for (const Kidnap& one : kidnaps) {
    wrong_ok += one.wrong_ok;
    wrong_posed += one.wrong_posed;
    list.push_back(json_of(one));
  }
  std::printf("%s: kidnapped %zu times\n", options.scenario.c_str(), kidnaps.size());
  print_delays("wrong pose no longer ok", kidnaps, &Kidnap::ok_until, 1.0);
  print_delays("wrong pose no longer given", kidnaps, &Kidnap::lost, 2.0);
  print_delays("three landmarks in a scan", kidnaps, &Kidnap::three, 5.0);
  print_delays("right pose", kidnaps, &Kidnap::pose, 5.0);
  print_delays("right pose, ok", kidnaps, &Kidnap::ok, 5.0);
  std::printf("  after that %zu scans with a wrong pose, %zu of them ok\n", wrong_posed, wrong_ok);
  return list;
}

}  // namespace

void evaluate_simulated_localization(const Options& options) {
  const Scenario scenario = read_scenario(options.scenario, options.variation);
  if (options.paths) return evaluate_simulated_paths(options, scenario);
  const nlohmann::json document = options.kidnaps > 0 ? evaluate_kidnapping(options, scenario)
                                                      : evaluate_drives(options, scenario);
  std::printf("%s\n", describe_resources().c_str());
  if (!options.json.empty()) write_json(options.json, document);
}

}  // namespace cli
}  // namespace falko_slam
