// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/CalibrationArc.h>
#include <falko_slam/CalibrationOutcome.h>

#include <vector>

#include "falko_slam/calibration/calibration_session.hpp"

namespace falko_slam {

/// With the residual against what was believed before.
CalibrationArc to_message(const SessionArc& arc);

/// Ticks to covariance.
PathSegment from_message(const CalibrationArc& message);

/// Verdict, remarks, parameters; the arcs are the caller's.
CalibrationOutcome to_message(const CalibrationResult& result);

/// Writes what a calibration says of its segments into the arcs that it was made of: segment i was
/// arc which[i]. All others are not used.
void add_reports(std::vector<CalibrationArc>& arcs, const CalibrationResult& result,
                 const std::vector<std::size_t>& which);

}  // namespace falko_slam
