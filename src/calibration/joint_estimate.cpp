// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "joint_estimate.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "falko_slam/common/chi_square.hpp"
#include "falko_slam/common/validation.hpp"
#include "noise_mixture.hpp"

namespace falko_slam {
namespace {

constexpr double kImprobable = 1e-3;  // tail of chi2 that is not put down to chance
constexpr double kTail = 0.025;       // on either side of a 95 % interval
constexpr int kSelections = 5;        // of outliers, at most
constexpr int kRelinearisations = 8;  // at most
constexpr double kSettled = 1e-3;     // a step of so many standard deviations is none

// Without what the phase has in common. Slip and steer noise count as great as they may be.
SegmentReport report_of(const MeasuredStretch& stretch, std::size_t phase, const StretchFit& fitted,
                        CalibrationNoise noise) {
  noise.slip *= noise.unknown_factor;
  noise.steer *= noise.unknown_factor;
  const StretchPrediction prediction =
      predict(fitted.calibration, stretch.arcs, fitted.common[phase]);
  SegmentReport report;
  report.phase = static_cast<DrivePhase>(phase);
  report.residual = stretch.motion - prediction.motion;
  Eigen::Matrix3d covariance = residual_covariance(stretch, prediction, noise);
  covariance += pose_covariance(noise.common_position, noise.common_turn);
  report.chi2 = report.residual.dot(covariance.llt().solve(report.residual));
  return report;
}

std::vector<bool> sound_ones(const StretchSet& set, const StretchFit& fitted,
                             const CalibrationNoise& noise, const OutlierParams& outliers) {
  const auto count = static_cast<double>(set.stretches.size());
  const double bound = chi_square_bound(outliers.probability / count, 3);
  std::vector<bool> sound;
  for (std::size_t i = 0; i < set.stretches.size(); ++i) {
    sound.push_back(report_of(set.stretches[i], set.phases[i], fitted, noise).chi2 <= bound);
  }
  // So many are no outliers; then the noise is not what it was said to be.
  const auto out = static_cast<double>(std::count(sound.begin(), sound.end(), false));
  if (out > outliers.max_share * count) sound.assign(sound.size(), true);
  return sound;
}

StretchFit fit_without_outliers(StretchSet& set, const FreeParameters& free,
                                const VehicleCalibration& start, const CalibrationNoise& noise,
                                const OutlierParams& outliers) {
  if (outliers.probability <= 0.0) return fit(set, free, start, noise, FitLoss::kNone);
  StretchFit fitted = fit(set, free, start, noise, FitLoss::kCauchy);
  for (int i = 0; i < kSelections; ++i) {
    const std::vector<bool> sound = sound_ones(set, fitted, noise, outliers);
    if (i > 0 && sound == set.used) break;
    set.used = sound;
    const int iterations = fitted.iterations;
    fitted = fit(set, free, fitted.calibration, noise, FitLoss::kNone);
    fitted.iterations += iterations;
  }
  return fitted;
}

// Mean, covariance and quantiles of the mixture around a point; returns the step to the mean.
Eigen::VectorXd take(const std::vector<MixtureComponent>& mixture, const FreeParameters& free,
                     JointEstimate& joint) {
  CalibrationEstimate& estimate = joint.estimate;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(free.count());
  Eigen::Matrix<double, 2 * kDrivePhases, 1> common =
      Eigen::Matrix<double, 2 * kDrivePhases, 1>::Zero();
  const MixtureComponent* likeliest = &mixture.front();
  std::vector<double> weights;
  for (const MixtureComponent& component : mixture) {
    mean += component.weight * component.correction;
    common += component.weight * component.common;
    weights.push_back(component.weight);
    if (component.weight > likeliest->weight) likeliest = &component;
  }
  joint.covariance_of_x = Eigen::MatrixXd::Zero(free.count(), free.count());
  for (const MixtureComponent& component : mixture) {
    const Eigen::VectorXd off = component.correction - mean;
    joint.covariance_of_x += component.weight * (component.covariance + off * off.transpose());
  }
  const CalibrationVector here = vector_of(estimate.calibration);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::VectorXd by_x = free.columns.row(row).transpose();
    std::vector<double> means, deviations;
    for (const MixtureComponent& component : mixture) {
      means.push_back(by_x.dot(component.correction));
      deviations.push_back(std::sqrt(by_x.dot(component.covariance * by_x)));
    }
    estimate.intervals[i] = {here[row] + mixture_quantile(weights, means, deviations, kTail),
                             here[row] + mixture_quantile(weights, means, deviations, 1.0 - kTail)};
  }
  for (std::size_t phase = 0; phase < kDrivePhases; ++phase) {
    const auto slip = static_cast<Eigen::Index>(phase);
    estimate.phase_errors[phase] = {common[slip],
                                    common[slip + static_cast<Eigen::Index>(kDrivePhases)]};
  }
  estimate.likeliest_noise = likeliest->noise;
  estimate.chi2 = likeliest->chi2;
  estimate.calibration = calibration_of(here + free.columns * mean);
  estimate.covariance = free.columns * joint.covariance_of_x * free.columns.transpose();
  return mean;
}

// Where even the likeliest noise leaves more than chance would.
void widen(JointEstimate& joint) {
  CalibrationEstimate& estimate = joint.estimate;
  if (chi_square_tail(estimate.chi2, estimate.degrees_of_freedom) >= kImprobable) return;
  estimate.excess = estimate.chi2 / estimate.degrees_of_freedom;
  estimate.covariance *= estimate.excess;
  joint.covariance_of_x *= estimate.excess;
  const CalibrationVector here = vector_of(estimate.calibration);
  for (std::size_t i = 0; i < kCalibrationParameters; ++i) {
    const double centre = here[static_cast<Eigen::Index>(i)];
    ParameterInterval& interval = estimate.intervals[i];
    interval.low = centre + std::sqrt(estimate.excess) * (interval.low - centre);
    interval.high = centre + std::sqrt(estimate.excess) * (interval.high - centre);
  }
}

}  // namespace

void validate(const OutlierParams& params) {
  require_in_range("probability", params.probability, 0.0, 0.5);
  require_in_range("max_share", params.max_share, 0.0, 0.5);
}

std::optional<JointEstimate> estimate_jointly(StretchSet& set, const FreeParameters& free,
                                              const VehicleCalibration& start,
                                              const CalibrationNoise& noise,
                                              const OutlierParams& outliers) {
  StretchFit fitted = fit_without_outliers(set, free, start, noise, outliers);
  JointEstimate joint;
  CalibrationEstimate& estimate = joint.estimate;
  estimate.calibration = fitted.calibration;
  estimate.iterations = fitted.iterations;
  for (int i = 0; i < kRelinearisations && !estimate.converged; ++i) {
    const auto mixture = noise_mixture(set, free, estimate.calibration, noise);
    if (mixture.empty()) return std::nullopt;
    const Eigen::VectorXd step = take(mixture, free, joint);
    const Eigen::VectorXd deviations = joint.covariance_of_x.diagonal().cwiseSqrt();
    estimate.converged = (step.cwiseAbs() - kSettled * deviations).maxCoeff() <= 0.0;
  }
  const auto used = static_cast<int>(std::count(set.used.begin(), set.used.end(), true));
  estimate.degrees_of_freedom = 3 * used - static_cast<int>(free.count());
  widen(joint);
  fitted.calibration = estimate.calibration;
  fitted.common = estimate.phase_errors;
  for (std::size_t i = 0; i < set.stretches.size(); ++i) {
    estimate.segments.push_back(report_of(set.stretches[i], set.phases[i], fitted, noise));
    estimate.segments.back().used = set.used[i];
  }
  return joint;
}

}  // namespace falko_slam
