// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/simulated_calibration.hpp"
#include "falko_slam/evaluation/thesis_calibration.hpp"

namespace falko_slam {

/// A row of Tables 5.1 and 5.2 of \cite kallasi2017, measured anew.
struct StudiedCondition {
  std::size_t number = 0;  ///< of the row, from 1
  MonteCarloReport report;
  ThesisCalibration published;
};

struct CalibrationStudy {
  TricycleModel model = TricycleModel::kAsymmetric;  ///< of the calibrator
  VehicleCalibration truth;
  std::vector<StudiedCondition> conditions;
};

/// The numbers of all rows, 1 to 20.
std::vector<std::size_t> all_condition_numbers();

/// The Monte Carlo under these conditions. Each has a sequence of random numbers of its own, made
/// of `params.seed` and its number, so that no row depends on which others are asked for. `tell` is
/// called before each. Throws std::invalid_argument if there is no such row.
CalibrationStudy study_calibration(
    const std::vector<std::size_t>& numbers, const MonteCarloParams& params,
    const std::function<void(std::size_t)>& tell = [](std::size_t) {});

/// The same in the complete simulator.
CalibrationStudy study_calibration(
    const std::vector<std::size_t>& numbers, const SimulatedCalibrationParams& params,
    const std::function<void(std::size_t)>& tell = [](std::size_t) {});

/// One parameter over all conditions: a column of the tables.
struct StudiedParameter {
  double deviation = 0.0;            ///< root mean square of the conditions' deviations
  double published_deviation = 0.0;  ///< the same of the published ones
  double over_bound = 0.0;  ///< root mean square of deviation over bound; 0: no bound is known
  double greatest_over_bound = 0.0;
  double greatest_bias = 0.0;  ///< in deviations
  double coverage = 0.0;       ///< of all runs
  int narrower = 0;            ///< conditions with less than the published deviation
};
/// Beside the table of that model.
StudiedParameter over_all(const CalibrationStudy& study, CalibrationParameter parameter,
                          TricycleModel table);

}  // namespace falko_slam
