// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/calibration/calibrator.hpp"
#include "stretch_fit.hpp"

namespace falko_slam {

/// Parameters whose standard deviation is beyond its limit, with the arc that would help each most.
std::vector<CalibrationRemark> weak_parameters(const StretchSet& set, const FreeParameters& free,
                                               const VehicleCalibration& calibration,
                                               const Eigen::MatrixXd& covariance_of_x,
                                               const CalibratorParams& params);

/// Which parameters the data tie: they may move together, further than any of them alone. Empty if
/// none are: where no standard deviation is more than ten times what it would be if all other
/// parameters were known. By the longest axis of the correlation's ellipsoid.
std::vector<CalibrationParameter> tied_parameters(const CalibrationMatrix& covariance);

}  // namespace falko_slam
