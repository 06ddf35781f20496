// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "falko_slam/calibration/calibration_noise.hpp"
#include "falko_slam/calibration/observability.hpp"
#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/vehicle_calibration.hpp"

namespace falko_slam {

/// Standard deviations beyond which a parameter is called weak.
struct CalibrationLimits {
  double steer_offset = 2e-3;    ///< [rad], [1e-9, 1]
  double driving_scale = 2e-3;   ///< share of the scale, [1e-9, 1]
  double laser_position = 0.01;  ///< of l_x and l_y [m], [1e-9, 10]
  double laser_theta = 2e-3;     ///< [rad], [1e-9, 1]
  double wheelbase = 2e-3;       ///< share of the wheelbase, [1e-9, 1]
  double steer_gain = 5e-3;      ///< share of the gain, [1e-9, 1]
};

struct CalibratorParams {
  TricycleModel model = TricycleModel::kAsymmetric;
  double wheelbase = 1.358;     ///< [m], [0.05, 20]
  double steer_gain = 1.0;      ///< of the measured steering, [0.01, 100]
  bool free_wheelbase = false;  ///< else it is what stands above
  bool free_steer_gain = false;
  CalibrationNoise noise;
  ObservabilityParams observability;
  CalibrationLimits limits;
  /// Chance that a set of sound segments loses one as an outlier, [0, 0.5]; 0: all count.
  double outlier_probability = 1e-3;
  double max_outlier_share = 0.25;          ///< more outliers are no outliers, [0, 0.5]
  std::optional<VehicleCalibration> start;  ///< of the refinement; else what the closed forms say
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibratorParams& params);

/// One segment against the calibration.
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

struct CalibrationResult {
  CalibrationVerdict verdict = CalibrationVerdict::kUnobservable;
  std::vector<CalibrationRemark> remarks;  ///< all that speaks against OK
  ObservabilityReport observability;
  /// Empty if the verdict is UNOBSERVABLE or CONTRADICTORY.
  std::optional<VehicleCalibration> calibration;
  CalibrationMatrix covariance = CalibrationMatrix::Zero();         ///< zero of what was held fast
  std::array<ParameterInterval, kCalibrationParameters> intervals;  ///< 95 %
  std::optional<VehicleCalibration> closed_form;        ///< where the refinement came from
  std::vector<SegmentReport> segments;                  ///< as they came
  std::array<EncoderError, kDrivePhases> phase_errors;  ///< common to a phase, most likely
  double chi2 = 0.0;  ///< of all segments used, with common errors as likely as any
  int degrees_of_freedom = 0;
  int iterations = 0;
};

/// Steer offsets, driving scale and pose of the laser, where asked for wheelbase and steer gain,
/// from arcs: closed forms, then maximum likelihood over all of them at once.
///
/// 1. Observability; where it lacks, there is no number.
/// 2. Closed forms, intrinsic and laser.
/// 3. Fit with a loss that outliers cannot pull far. A segment whose residual no sound one of so
///    many would have is left out. Common errors of a phase have variables here, so that a phase
///    that slipped is no outlier.
/// 4. Fit of the rest: residuals weighted by the segment's own covariance with slip and steer error
///    of the segment propagated into it (CalibrationNoise).
/// 5. Covariance and intervals over all common errors that the spread between the phases allows.
///    Where the spread tells little, the tails are long, as they have to be.
/// Throws std::invalid_argument if a segment or a parameter is none.
CalibrationResult calibrate(const std::vector<PathSegment>& segments,
                            const CalibratorParams& params = {});

}  // namespace falko_slam
