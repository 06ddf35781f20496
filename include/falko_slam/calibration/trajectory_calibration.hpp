// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "falko_slam/calibration/calibration_report.hpp"
#include "falko_slam/vehicle/encoder_reading.hpp"

namespace falko_slam {

/// An instant of a logged drive: what the encoders say, and where the laser is.
struct DriveRecord {
  EncoderReading encoders;
  Pose2 world_T_laser;
};

struct TrajectoryCalibratorParams {
  TricycleModel model = TricycleModel::kStandard;
  VehicleCalibration nominal;  ///< where the fit begins; what is held stays as it is here
  EncoderParams encoders;      ///< its steer gain comes before that of the calibration
  bool free_wheelbase = true;
  bool free_steer_gain = true;
  double window =
      1.0;  ///< way of the driven wheel that is fitted at once, nominal [m], [0.01, 1e3]
  double position_noise = 0.005;  ///< standard deviation of the laser's coordinates [m], (0, 10]
  double heading_noise = 1e-3;    ///< of its heading [rad], (0, 1]
  /// Of the time by which the encoders tell of another instant than the pose, as where their
  /// counters come in gusts [s], [0, 10].
  double timing_noise = 0.02;
  /// Of a window. A drive has no phases, so nothing is in common.
  CalibrationNoise noise{0.01, 0.01, 0.0, 0.0, 0.0, 0.0, 8.0};
  OutlierParams outliers;
  CalibrationLimits limits;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const TrajectoryCalibratorParams& params);

/// The records from first to last are one measurement.
struct DriveWindow {
  std::size_t first = 0, last = 0;
};

/// How far the laser's positions by odometry are from the true ones, over all records; the first
/// ones are one.
struct DriveError {
  double mean = 0.0;      ///< [m]
  double greatest = 0.0;  ///< [m]
};

struct TrajectoryCalibrationResult {
  CalibrationVerdict verdict = CalibrationVerdict::kUnobservable;
  std::vector<CalibrationRemark> remarks;
  std::optional<CalibrationEstimate> estimate;  ///< empty if UNOBSERVABLE
  std::vector<DriveWindow> windows;             ///< in the order of estimate->segments
  std::vector<CalibrationParameter> tied;       ///< that may move together further than alone
  DriveError nominal_error, error;
};

/// Parameters of a vehicle from a drive with any steering, where arcs cannot be ordered. Windows of
/// the drive take the place of path segments: their motion is the product of the exact arcs between
/// records, each steered by the mean of its ends, so the straight limit needs no care. Everything
/// else is calibrate() from step 3 on. Without closed forms the fit begins at the nominal values.
/// Throws std::invalid_argument if a parameter or a record is none.
TrajectoryCalibrationResult calibrate_trajectory(const std::vector<DriveRecord>& records,
                                                 const TrajectoryCalibratorParams& params);

/// Odometry of the whole drive with a calibration, against the truth.
DriveError drive_error(const std::vector<DriveRecord>& records, const EncoderParams& encoders,
                       const VehicleCalibration& calibration);

}  // namespace falko_slam
