// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "joint_estimate.hpp"

namespace falko_slam {

/// "drive more arcs forward left, half a turn steered by about 50 degrees": of the arcs that can be
/// driven, the one that would leave this parameter with the least variance.
std::string next_arc_for(CalibrationParameter parameter, const StretchSet& set,
                         const FreeParameters& free, const JointEstimate& joint,
                         const CalibrationNoise& noise);

}  // namespace falko_slam
