// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/calibration_study.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "falko_slam/common/random_sequence.hpp"
#include "falko_slam/evaluation/vehicle_knowledge.hpp"

namespace falko_slam {
namespace {

VehicleCalibration truth_of(const MonteCarloParams& params) { return params.truth; }
VehicleCalibration truth_of(const SimulatedCalibrationParams& params) {
  return true_calibration(params.vehicle);
}

template <class Params, class Run>
CalibrationStudy study(const std::vector<std::size_t>& numbers, Params params,
                       const std::function<void(std::size_t)>& tell, Run run) {
  const auto conditions = thesis_conditions();
  const auto published = thesis_calibrations();
  const std::uint64_t seed = params.seed;
  for (const std::size_t number : numbers) {
    if (number >= 1 && number <= conditions.size()) continue;
    throw std::invalid_argument("conditions: " + std::to_string(number) + " is not in [1, " +
                                std::to_string(conditions.size()) + "]");
  }
  CalibrationStudy study{params.calibrator.model, truth_of(params), {}};
  for (const std::size_t number : numbers) {
    tell(number);
    params.seed = random_sequence(seed, {static_cast<std::uint32_t>(number)})();
    study.conditions.push_back(
        {number, run(conditions[number - 1], params), published[number - 1]});
  }
  return study;
}

}  // namespace

std::vector<std::size_t> all_condition_numbers() {
  std::vector<std::size_t> numbers(thesis_conditions().size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  return numbers;
}

CalibrationStudy study_calibration(const std::vector<std::size_t>& numbers,
                                   const MonteCarloParams& params,
                                   const std::function<void(std::size_t)>& tell) {
  return study(numbers, params, tell, run_monte_carlo);
}

CalibrationStudy study_calibration(const std::vector<std::size_t>& numbers,
                                   const SimulatedCalibrationParams& params,
                                   const std::function<void(std::size_t)>& tell) {
  return study(numbers, params, tell, run_simulated_calibrations);
}

StudiedParameter over_all(const CalibrationStudy& study, CalibrationParameter parameter,
                          TricycleModel table) {
  StudiedParameter column;
  double runs = 0.0;
  for (const StudiedCondition& condition : study.conditions) {
    const ParameterStatistics& here = condition.report.parameters[index_of(parameter)];
    const double published =
        condition.published.of(table).deviation[static_cast<Eigen::Index>(index_of(parameter))];
    const double count = condition.report.runs;
    column.deviation += here.deviation * here.deviation;
    column.published_deviation += published * published;
    if (here.bound > 0.0) {
      const double ratio = here.deviation / here.bound;
      column.over_bound += ratio * ratio;
      column.greatest_over_bound = std::max(column.greatest_over_bound, ratio);
    }
    if (here.deviation > 0.0) {
      column.greatest_bias = std::max(column.greatest_bias, std::abs(here.bias) / here.deviation);
    }
    column.coverage += count * here.coverage;
    column.narrower += here.deviation < published ? 1 : 0;
    runs += count;
  }
  const double rows = std::max(1.0, static_cast<double>(study.conditions.size()));
  column.deviation = std::sqrt(column.deviation / rows);
  column.published_deviation = std::sqrt(column.published_deviation / rows);
  column.over_bound = std::sqrt(column.over_bound / rows);
  column.coverage /= std::max(1.0, runs);
  return column;
}

}  // namespace falko_slam
