// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "path_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "console.hpp"
#include "falko_slam/evaluation/path_evaluation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace cli {
namespace {

using Options = SimulatedLocalizationOptions;
// By path, by method; a run for each seed.
using PathRuns = std::map<std::string, std::map<PathMethod, std::vector<PathRun>>>;

std::vector<PathMethod> methods_of(const Options& options) {
  std::vector<PathMethod> methods = {PathMethod::kState, PathMethod::kExternalMap,
                                     PathMethod::kOdometry};
  if (!options.map.empty()) methods.insert(methods.begin(), PathMethod::kMap);
  return methods;
}

PathRuns run_all(const Options& options, const Scenario& scenario) {
  const LocalizerParams params = parameters_of(options, scenario.world);
  PathRuns runs;
  for (const std::uint64_t seed : options.seeds) {
    const SimulatedDrive drive = drive_of(options, scenario, seed);
    if (drive.legs.empty()) {
      throw std::runtime_error(options.scenario +
                               ": no step of its drive has a name: there are no paths");
    }
    Options surveyed = options;
    surveyed.map.clear();
    for (const PathMethod method : methods_of(options)) {
      const Options& wanted = method == PathMethod::kMap ? options : surveyed;
      const LandmarkMap map = map_of(wanted, scenario.world, seed);
      for (PathRun& run : evaluate_paths(drive, method, params, map)) {
        runs[run.path][method].push_back(std::move(run));
      }
    }
  }
  return runs;
}

struct WorstOf {
  std::size_t within = 0;
  double along = 0.0, across = 0.0, heading = 0.0, position = 0.0, nees = 0.0;
  double way_position = 0.0, way_heading = 0.0;
};

WorstOf worst_of(const std::vector<PathRun>& runs) {
  WorstOf worst;
  for (const PathRun& run : runs) {
    if (is_within(run)) ++worst.within;
    if (run.errors.empty()) continue;
    const PathError& end = run.errors.back();
    worst.along = std::max(worst.along, std::abs(end.along));
    worst.across = std::max(worst.across, std::abs(end.across));
    worst.position = std::max(worst.position, std::hypot(end.along, end.across));
    worst.heading = std::max(worst.heading, std::abs(end.heading));
    worst.nees += run.nees / static_cast<double>(runs.size());
    for (const PathError& error : run.errors) {
      worst.way_position = std::max(worst.way_position, std::hypot(error.along, error.across));
      worst.way_heading = std::max(worst.way_heading, std::abs(error.heading));
    }
  }
  return worst;
}

void print(const PathRuns& runs) {
  std::printf(
      "                                 within   worst at the operation point           mean  "
      "worst on the way\n"
      "path       method                2 cm,    along  across  position  heading     NEES  "
      "position  heading\n"
      "                                 .1 deg    [mm]    [mm]      [mm]    [deg]  (ideal 3)"
      "     [mm]    [deg]\n");
  for (const auto& [path, by_method] : runs) {
    for (const auto& [method, all] : by_method) {
      const WorstOf worst = worst_of(all);
      std::printf("%-10s %-21s %2zu of %-2zu %7.1f %7.1f %9.1f %8.3f %9.1f %9.1f %8.3f\n",
                  path.c_str(), name_of(method), worst.within, all.size(), 1e3 * worst.along,
                  1e3 * worst.across, 1e3 * worst.position, radians_to_degrees(worst.heading),
                  worst.nees, 1e3 * worst.way_position, radians_to_degrees(worst.way_heading));
    }
  }
}

nlohmann::json json_of(const Options& options, const PathRuns& runs) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [path, by_method] : runs) {
    for (const auto& [method, all] : by_method) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        nlohmann::json errors = nlohmann::json::array();
        for (const PathError& error : all[i].errors) {
          errors.push_back({error.way, error.along, error.across, error.heading});
        }
        list.push_back({{"path", path},
                        {"method", name_of(method)},
                        {"seed", options.seeds[i]},
                        {"within", is_within(all[i])},
                        {"nees", all[i].nees},
                        {"errors", errors}});
      }
    }
  }
  return list;
}

}  // namespace

void evaluate_simulated_paths(const Options& options, const Scenario& scenario) {
  std::printf("%s, scatter x %g, bulge x %g, survey noise %.1f mm\n", options.scenario.c_str(),
              options.variation.scatter, options.variation.bulge, 1e3 * options.survey_noise);
  const PathRuns runs = run_all(options, scenario);
  print(runs);
  std::printf("%s\n", describe_resources().c_str());
  if (!options.json.empty()) write_json(options.json, json_of(options, runs));
}

}  // namespace cli
}  // namespace falko_slam
