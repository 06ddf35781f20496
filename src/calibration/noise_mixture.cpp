// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "noise_mixture.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "whitened_sums.hpp"

namespace falko_slam {
namespace {

// Of common errors: the least is a 128th of the greatest, as good as none.
constexpr int kLevels = 8;

double log_determinant(const Eigen::MatrixXd& lower) {
  return 2.0 * lower.diagonal().array().log().sum();
}

// With V = I + Z T^2 Z^T and Woodbury's identity. Returns the logarithm of the restricted
// likelihood.
double solve(const WhitenedSums& sums, MixtureComponent& component) {
  CommonVector T;
  T << CommonVector::Constant(component.noise.common_slip).head<kCommonErrors / 2>(),
      CommonVector::Constant(component.noise.common_steer).head<kCommonErrors / 2>();
  const CommonMatrix scaled = T.asDiagonal() * sums.ZtZ() * T.asDiagonal();
  const Eigen::LLT<CommonMatrix> D(CommonMatrix::Identity() + scaled);
  const Eigen::MatrixXd TZtH = T.asDiagonal() * sums.HtZ().transpose();
  const CommonVector TZtr = T.asDiagonal() * sums.Ztr();
  const Eigen::MatrixXd information = sums.HtH() - TZtH.transpose() * D.solve(TZtH);
  const Eigen::VectorXd right = sums.Htr() - TZtH.transpose() * D.solve(TZtr);
  const Eigen::LLT<Eigen::MatrixXd> root(information);
  if (root.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
  component.correction = root.solve(right);
  component.covariance =
      root.solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  const CommonVector left = TZtr - TZtH * component.correction;
  component.common = T.asDiagonal() * D.solve(left);
  component.chi2 = sums.rtr() - TZtr.dot(D.solve(TZtr)) - component.correction.dot(right);
  return -0.5 * (component.chi2 + sums.log_determinant() + log_determinant(D.matrixL()) +
                 log_determinant(root.matrixL()));
}

// All levels are equally probable.
std::vector<double> common_levels(double greatest) {
  if (greatest <= 0.0) return {0.0};
  std::vector<double> levels;
  levels.reserve(kLevels);
  for (int i = 0; i < kLevels; ++i) levels.push_back(greatest * std::pow(2.0, -i));
  return levels;
}

std::vector<double> factor_levels(double most) {
  std::vector<double> levels = {1.0};
  for (double factor = 2.0; factor <= most; factor *= 2.0) {
    levels.push_back(factor);
    levels.push_back(1.0 / factor);
  }
  return levels;
}

void normalise(std::vector<MixtureComponent>& mixture) {
  double most = -std::numeric_limits<double>::infinity();
  for (const MixtureComponent& component : mixture) most = std::max(most, component.weight);
  double sum = 0.0;
  for (MixtureComponent& component : mixture) {
    component.weight = std::exp(component.weight - most);
    sum += component.weight;
  }
  for (MixtureComponent& component : mixture) component.weight /= sum;
}

std::vector<StretchPrediction> predictions_of(const StretchSet& set,
                                              const VehicleCalibration& calibration) {
  std::vector<StretchPrediction> predictions;
  for (const MeasuredStretch& stretch : set.stretches) {
    predictions.push_back(predict(calibration, stretch.arcs));
  }
  return predictions;
}

}  // namespace

MixtureComponent estimate_with(const StretchSet& set, const FreeParameters& free,
                               const VehicleCalibration& linearised_at,
                               const CalibrationNoise& noise) {
  MixtureComponent component;
  component.noise = noise;
  component.weight = 1.0;
  solve(WhitenedSums(set, free, predictions_of(set, linearised_at), noise), component);
  return component;
}

std::vector<MixtureComponent> noise_mixture(const StretchSet& set, const FreeParameters& free,
                                            const VehicleCalibration& linearised_at,
                                            const CalibrationNoise& noise) {
  const std::vector<StretchPrediction> predictions = predictions_of(set, linearised_at);
  std::vector<MixtureComponent> mixture;
  for (const double slip_factor : factor_levels(noise.unknown_factor)) {
    for (const double steer_factor : factor_levels(noise.unknown_factor)) {
      CalibrationNoise alone = noise;
      alone.slip *= slip_factor;
      alone.steer *= steer_factor;
      const WhitenedSums sums(set, free, predictions, alone);
      for (const double slip : common_levels(noise.common_slip)) {
        for (const double steer : common_levels(noise.common_steer)) {
          MixtureComponent component;
          component.noise = alone;
          component.noise.common_slip = slip;
          component.noise.common_steer = steer;
          component.weight = solve(sums, component);
          if (std::isfinite(component.weight)) mixture.push_back(component);
        }
      }
    }
  }
  normalise(mixture);
  return mixture;
}

double mixture_quantile(const std::vector<double>& weights, const std::vector<double>& means,
                        const std::vector<double>& standard_deviations, double probability) {
  constexpr double kFar = 40.0;  // standard deviations
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    low = std::min(low, means[i] - kFar * standard_deviations[i]);
    high = std::max(high, means[i] + kFar * standard_deviations[i]);
  }
  for (int iteration = 0; iteration < 80; ++iteration) {
    const double x = 0.5 * (low + high);
    double below = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (standard_deviations[i] > 0.0) {
        below += weights[i] * 0.5 *
                 std::erfc((means[i] - x) / (std::sqrt(2.0) * standard_deviations[i]));
      } else if (means[i] <= x) {
        below += weights[i];
      }
    }
    (below < probability ? low : high) = x;
  }
  return 0.5 * (low + high);
}

}  // namespace falko_slam
