// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "falko_slam/calibration/calibrator.hpp"
#include "falko_slam/calibration/trajectory_calibration.hpp"

namespace falko_slam {

/// What a calibration was made from.
struct CalibrationConditions {
  int segments = 0;  ///< or windows of a drive
  int left_out = 0;  ///< outliers among them
  double chi2 = 0.0;
  int degrees_of_freedom = 0;
  double forward_condition = 1.0;  ///< as in ObservabilityReport; 1 where there are no arcs
  double backward_condition = 1.0;
  double laser_condition = 1.0;
};

/// A calibration as it is kept in a file, in SI units.
struct StoredCalibration {
  std::string date;  ///< as the caller writes it, "2024-05-31T12:00:00Z"
  TricycleModel model = TricycleModel::kAsymmetric;
  CalibrationVerdict verdict = CalibrationVerdict::kOk;  ///< OK or WEAK
  VehicleCalibration calibration;
  CalibrationMatrix covariance = CalibrationMatrix::Zero();
  std::array<ParameterInterval, kCalibrationParameters> intervals;  ///< 95 %
  CalibrationConditions conditions;
  std::vector<std::string> remarks;  ///< "WEAK: reason; remedy"
};

/// Throws std::invalid_argument if the result has no numbers: they must not get into a file.
StoredCalibration stored_calibration(const CalibrationResult& result, TricycleModel model,
                                     const std::string& date);
StoredCalibration stored_calibration(const TrajectoryCalibrationResult& result, TricycleModel model,
                                     const std::string& date);

/// Where the calibration that was there before is kept: "agv.yaml" -> "agv.previous.yaml".
std::string previous_calibration_path(const std::string& path);

/// As YAML, whole or not at all; what was there before is kept beside it. Throws
/// std::invalid_argument if it would not be read back, std::runtime_error that names the file if it
/// cannot be written; then the old one is still there.
void write_calibration(const std::string& path, const StoredCalibration& stored);

/// Throws std::runtime_error that names file, line and key: what is missing, unknown, out of its
/// range, no covariance, or cut off.
StoredCalibration read_calibration(const std::string& path);

}  // namespace falko_slam
