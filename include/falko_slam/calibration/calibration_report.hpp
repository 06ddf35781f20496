// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "falko_slam/calibration/calibration_noise.hpp"
#include "falko_slam/calibration/observability.hpp"
#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/vehicle_calibration.hpp"

namespace falko_slam {

/// Which measurements do not count.
struct OutlierParams {
  /// Chance that a set of sound segments loses one as an outlier, [0, 0.5]; 0: all count.
  double probability = 1e-3;
  double max_share = 0.25;  ///< more outliers are no outliers, [0, 0.5]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const OutlierParams& params);

/// Standard deviations beyond which a parameter is called weak.
struct CalibrationLimits {
  double steer_offset = 2e-3;    ///< [rad], [1e-9, 1]
  double driving_scale = 2e-3;   ///< share of the scale, [1e-9, 1]
  double laser_position = 0.01;  ///< of l_x and l_y [m], [1e-9, 10]
  double laser_theta = 2e-3;     ///< [rad], [1e-9, 1]
  double wheelbase = 2e-3;       ///< share of the wheelbase, [1e-9, 1]
  double steer_gain = 5e-3;      ///< share of the gain, [1e-9, 1]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibrationLimits& limits);

/// One segment, or one window of a drive, against the calibration.
struct SegmentReport {
  DrivePhase phase = DrivePhase::kForwardLeft;
  /// Measured minus expected motion of the laser, (x [m], y [m], turn [rad]), without what its
  /// phase has in common.
  Eigen::Vector3d residual = Eigen::Vector3d::Zero();
  double chi2 = 0.0;  ///< of the residual, of three degrees of freedom
  bool used = true;   ///< false: an outlier that was left out
};

struct ParameterInterval {
  double low = 0.0;
  double high = 0.0;
};

/// What a maximum-likelihood fit says, however its measurements were made.
struct CalibrationEstimate {
  VehicleCalibration calibration;
  CalibrationMatrix covariance = CalibrationMatrix::Zero();         ///< zero of what was held fast
  std::array<ParameterInterval, kCalibrationParameters> intervals;  ///< 95 %
  std::vector<SegmentReport> segments;                              ///< as they came
  std::array<EncoderError, kDrivePhases> phase_errors;  ///< common to a phase, as expected
  CalibrationNoise likeliest_noise;  ///< common_slip and common_steer as standard deviations
  double chi2 = 0.0;                 ///< of all segments used, under that noise
  int degrees_of_freedom = 0;
  /// By how much the covariance was multiplied, as chi2 is not to be put down to chance; else 1.
  double excess = 1.0;
  int iterations = 0;
  bool converged = false;
};

}  // namespace falko_slam
