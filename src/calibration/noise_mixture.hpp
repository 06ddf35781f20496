// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "stretch_fit.hpp"

namespace falko_slam {

/// What a calibration is if the noise is this: a correction to the point of linearisation.
struct MixtureComponent {
  double weight = 0.0;         ///< probability, all of them sum up to 1
  CalibrationNoise noise;      ///< common_slip and common_steer are standard deviations here
  Eigen::VectorXd correction;  ///< of x
  Eigen::MatrixXd covariance;  ///< of x
  Eigen::Matrix<double, 2 * kDrivePhases, 1> common;  ///< slip of the phases, then steer
  double chi2 = 0.0;  ///< what is left of the residuals, of 3 n - (number of x) degrees of freedom
};

/// How great the errors are that a phase has in common, nobody knows; four phases tell little. So
/// all values are taken at once, each weighted by how well it explains the residuals:
///
///     r = H x + Z u + e,   u ~ N(0, T^2), e ~ N(0, diag(Sigma_k))
///
/// with u the common slip and steer error of the phases. x is integrated out with a flat prior
/// (restricted likelihood), so the degrees of freedom it takes are not counted twice. The values of
/// T are in even ratios and equally probable, up to the greatest in the noise: 0 has no weight of
/// its own, for what is given to it is missing where common errors are just too small to be seen.
std::vector<MixtureComponent> noise_mixture(const StretchSet& set, const FreeParameters& free,
                                            const VehicleCalibration& linearised_at,
                                            const CalibrationNoise& noise);

/// The same where all of the noise is known: common_slip and common_steer are standard deviations.
/// Its covariance at the truth is the Cramer-Rao bound.
MixtureComponent estimate_with(const StretchSet& set, const FreeParameters& free,
                               const VehicleCalibration& linearised_at,
                               const CalibrationNoise& noise);

/// The x below which the mixture of normal distributions has this probability.
double mixture_quantile(const std::vector<double>& weights, const std::vector<double>& means,
                        const std::vector<double>& standard_deviations, double probability);

}  // namespace falko_slam
