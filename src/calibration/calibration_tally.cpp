// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_tally.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/chi_square.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// The heading of the laser wraps.
CalibrationVector deviation_of(const VehicleCalibration& estimate,
                               const VehicleCalibration& truth) {
  CalibrationVector deviation = vector_of(estimate) - vector_of(truth);
  const auto theta = static_cast<Eigen::Index>(index_of(CalibrationParameter::kLaserTheta));
  deviation[theta] = angle_between(truth.base_T_laser.theta(), estimate.base_T_laser.theta());
  return deviation;
}

}  // namespace

DeviationScatter scatter_of_deviation(int runs) {
  const int freedom = std::max(1, runs - 1);
  return {std::sqrt(chi_square_bound(0.975, freedom) / freedom),
          std::sqrt(chi_square_bound(0.025, freedom) / freedom)};
}

void CalibrationTally::Spread::add(const CalibrationVector& value, double count) {
  const CalibrationVector before = value - mean;
  mean += before / count;
  squares += before.cwiseProduct(value - mean);
}

void CalibrationTally::add(const CalibrationResult& result, const CalibrationVector& bound) {
  if (!result.estimate) {
    ++refused_;
    return;
  }
  const CalibrationEstimate& estimate = *result.estimate;
  ++runs_;
  closed_form_.add(deviation_of(*result.closed_form, truth_), runs_);
  likeliest_.add(deviation_of(estimate.calibration, truth_), runs_);
  bounds_ += bound;
  const CalibrationVector truth = vector_of(truth_);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const ParameterInterval& interval = estimate.intervals[i];
    covered_[row] += interval.low <= truth[row] && truth[row] <= interval.high ? 1.0 : 0.0;
    widths_[row] += 0.5 * (interval.high - interval.low);
  }
  for (const SegmentReport& segment : estimate.segments) outliers_ += segment.used ? 0.0 : 1.0;
  segments_ += static_cast<double>(estimate.segments.size());
  chi2_ += estimate.chi2 / estimate.degrees_of_freedom;
}

CalibrationStatistics CalibrationTally::statistics() const {
  CalibrationStatistics statistics;
  const double runs = std::max(1, runs_), freedom = std::max(1, runs_ - 1);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    statistics[i] = {std::sqrt(closed_form_.squares[row] / freedom),
                     std::sqrt(likeliest_.squares[row] / freedom),
                     std::sqrt(bounds_[row] / runs),
                     likeliest_.mean[row],
                     covered_[row] / runs,
                     widths_[row] / runs};
  }
  return statistics;
}

double CalibrationTally::outlier_share() const { return outliers_ / std::max(1.0, segments_); }

double CalibrationTally::mean_chi2() const { return chi2_ / std::max(1, runs_); }

}  // namespace falko_slam
