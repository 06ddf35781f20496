// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "falko_slam/calibration/calibration_noise.hpp"
#include "falko_slam/calibration/calibration_report.hpp"
#include "falko_slam/calibration/observability.hpp"
#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/vehicle_calibration.hpp"

namespace falko_slam {

struct CalibratorParams {
  TricycleModel model = TricycleModel::kAsymmetric;
  double wheelbase = 1.358;     ///< [m], [0.05, 20]
  double steer_gain = 1.0;      ///< of the measured steering, [0.01, 100]
  bool free_wheelbase = false;  ///< else it is what stands above
  bool free_steer_gain = false;
  CalibrationNoise noise;
  ObservabilityParams observability;
  CalibrationLimits limits;
  OutlierParams outliers;
  std::optional<VehicleCalibration> start;  ///< of the refinement; else what the closed forms say
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibratorParams& params);

struct CalibrationResult {
  CalibrationVerdict verdict = CalibrationVerdict::kUnobservable;
  std::vector<CalibrationRemark> remarks;  ///< all that speaks against OK, and outliers by name
  ObservabilityReport observability;
  std::optional<VehicleCalibration> closed_form;  ///< where the refinement came from
  /// Empty if the verdict is UNOBSERVABLE or CONTRADICTORY.
  std::optional<CalibrationEstimate> estimate;
  std::vector<CalibrationParameter> tied;  ///< that may move together further than alone
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
