// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/monte_carlo.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "noise_mixture.hpp"

namespace falko_slam {
namespace {

// Mean and spread of vectors, one by one.
class Spread {
 public:
  void add(const CalibrationVector& deviation) {
    ++count_;
    const CalibrationVector before = deviation - mean_;
    mean_ += before / count_;
    squares_ += before.cwiseProduct(deviation - mean_);
  }
  const CalibrationVector& mean() const { return mean_; }
  CalibrationVector deviation() const {
    return (squares_ / std::max(1.0, count_ - 1.0)).cwiseSqrt();
  }

 private:
  double count_ = 0.0;
  CalibrationVector mean_ = CalibrationVector::Zero(), squares_ = CalibrationVector::Zero();
};

// Covariance of the best estimate there can be from segments seen as well as these.
CalibrationVector bound_of(const std::vector<PathSegment>& segments,
                           const MonteCarloParams& params) {
  StretchSet set;
  for (const PathSegment& segment : segments) {
    set.stretches.push_back(stretch_of(segment));
    set.phases.push_back(static_cast<std::size_t>(phase_of(segment)));
  }
  set.used.assign(segments.size(), true);
  const CalibratorParams& calibrator = params.calibrator;
  const FreeParameters free = free_parameters(
      {calibrator.model, calibrator.free_wheelbase, calibrator.free_steer_gain}, params.truth);
  CalibrationNoise noise;
  noise.slip = params.noise.slip;
  noise.steer = params.noise.steer;
  noise.common_slip = params.noise.common_slip;
  noise.common_steer = params.noise.common_steer;
  const Eigen::MatrixXd covariance = estimate_with(set, free, params.truth, noise).covariance;
  return (free.columns * covariance * free.columns.transpose()).diagonal();
}

// Differences of what both estimates say and what is true; the heading of the laser wraps.
CalibrationVector deviation_of(const VehicleCalibration& estimate,
                               const VehicleCalibration& truth) {
  CalibrationVector deviation = vector_of(estimate) - vector_of(truth);
  const auto theta = static_cast<Eigen::Index>(index_of(CalibrationParameter::kLaserTheta));
  deviation[theta] = angle_between(truth.base_T_laser.theta(), estimate.base_T_laser.theta());
  return deviation;
}

}  // namespace

MonteCarloReport run_monte_carlo(const CalibrationCondition& condition,
                                 const MonteCarloParams& params) {
  validate(condition);
  validate(params);
  std::mt19937_64 random(params.seed);
  MonteCarloReport report;
  report.condition = condition;
  const CalibrationVector truth = vector_of(params.truth);
  Spread closed_form, likeliest;
  CalibrationVector bounds = CalibrationVector::Zero(), covered = bounds, widths = bounds;
  double outliers = 0.0, chi2 = 0.0;
  for (int run = 0; run < params.runs; ++run) {
    const auto segments = simulate_calibration_drive(condition, params, random);
    const CalibrationResult result = calibrate(segments, params.calibrator);
    if (!result.estimate) {
      ++report.refused;
      continue;
    }
    const CalibrationEstimate& estimate = *result.estimate;
    ++report.runs;
    closed_form.add(deviation_of(*result.closed_form, params.truth));
    likeliest.add(deviation_of(estimate.calibration, params.truth));
    bounds += bound_of(segments, params);
    for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const ParameterInterval& interval = estimate.intervals[i];
      covered[row] += interval.low <= truth[row] && truth[row] <= interval.high ? 1.0 : 0.0;
      widths[row] += 0.5 * (interval.high - interval.low);
    }
    for (const SegmentReport& segment : estimate.segments) outliers += segment.used ? 0.0 : 1.0;
    chi2 += estimate.chi2 / estimate.degrees_of_freedom;
  }
  const double runs = std::max(1, report.runs);
  report.outlier_share = outliers / runs / (4.0 * condition.arcs_per_phase);
  report.mean_chi2 = chi2 / runs;
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    report.parameters[i] = {closed_form.deviation()[row],  likeliest.deviation()[row],
                            std::sqrt(bounds[row] / runs), likeliest.mean()[row],
                            covered[row] / runs,           widths[row] / runs};
  }
  return report;
}

}  // namespace falko_slam
