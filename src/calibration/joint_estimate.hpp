// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "falko_slam/calibration/calibration_report.hpp"
#include "stretch_fit.hpp"

namespace falko_slam {

struct JointEstimate {
  CalibrationEstimate estimate;
  Eigen::MatrixXd covariance_of_x;  ///< of the free parameters
};

/// Outliers out, maximum likelihood, covariance and intervals over all noise that may be: steps 3
/// to 5 of calibrate(). Marks in the set what was left out. Empty if the equations are singular.
std::optional<JointEstimate> estimate_jointly(StretchSet& set, const FreeParameters& free,
                                              const VehicleCalibration& start,
                                              const CalibrationNoise& noise,
                                              const OutlierParams& outliers);

}  // namespace falko_slam
