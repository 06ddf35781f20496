// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "falko_slam/evaluation/kidnap_evaluation.hpp"
#include "falko_slam/evaluation/localization_evaluation.hpp"
#include "falko_slam/simulation/scenario_file.hpp"
#include "falko_slam/vehicle/odometry_noise.hpp"

namespace falko_slam {
namespace cli {

struct SimulatedLocalizationOptions {
  std::string scenario;
  std::vector<std::uint64_t> seeds = {1, 2, 3, 4, 5, 6};
  double duration = 1e6;      ///< of each drive at most [s]
  double survey_noise = 0.0;  ///< of the map [m]
  std::string map;            ///< YAML file in place of the surveyed reflectors; empty: none
  int kidnaps = 0;            ///< 0: drives without any
  OdometryNoise odometry;
  bool perfect_calibration = false;
  bool paths = false;        ///< the named paths of the drive instead of all of it
  WorldVariation variation;  ///< of the scenario
  std::string parameters;    ///< YAML file with groups of visit_localizer_fields(); empty: none
  std::string json;          ///< empty: none
  LocalizerParams localizer;
};

/// What the scenario's vehicle is taken for.
SimulatedDrive drive_of(const SimulatedLocalizationOptions& options, const Scenario& scenario,
                        std::uint64_t seed);
LocalizerParams parameters_of(const SimulatedLocalizationOptions& options, const World& world);
LandmarkMap map_of(const SimulatedLocalizationOptions& options, const World& world,
                   std::uint64_t seed);

/// The localizer on simulated drives of a scenario; prints the figures.
void evaluate_simulated_localization(const SimulatedLocalizationOptions& options);

}  // namespace cli
}  // namespace falko_slam
