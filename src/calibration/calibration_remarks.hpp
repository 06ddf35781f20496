// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/calibration/calibration_report.hpp"
#include "joint_estimate.hpp"

namespace falko_slam {

/// "driving_scale, wheelbase".
std::string list_of(const std::vector<CalibrationParameter>& parameters);

/// Which parameters the data tie: they may move together, much further than any of them alone.
/// Empty where no standard deviation is more than three times what it would be if all other
/// parameters were known; else those along the longest axis of the correlation's ellipsoid.
std::vector<CalibrationParameter> tied_parameters(const CalibrationMatrix& covariance);

struct RemarkParams {
  const CalibrationLimits& limits;
  const CalibrationNoise& noise;
  bool arcs = true;  ///< whether arcs can be asked for
};

/// What there is to say of an estimate: segments left out, noise greater than was said, no
/// convergence, ties, and parameters whose standard deviation is beyond its limit with the arc that
/// would help each most.
std::vector<CalibrationRemark> remarks_on(const StretchSet& set, const FreeParameters& free,
                                          const JointEstimate& joint,
                                          const std::vector<CalibrationParameter>& tied,
                                          const RemarkParams& params);

}  // namespace falko_slam
