// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <vector>

#include "falko_slam/calibration/recorded_calibration.hpp"
#include "falko_slam/calibration/trajectory_calibration.hpp"

namespace falko_slam {
namespace cli {

// Tables for people.

/// Each recorded segment with its residual, or why it is none.
void print_segments(std::ostream& out, const std::vector<RecordedSegment>& recorded,
                    const RecordedCalibration& calibration);

/// Verdict, remarks, parameters with standard deviations and 95 % intervals.
void print(std::ostream& out, const CalibrationResult& result);
void print(std::ostream& out, const TrajectoryCalibrationResult& result);

}  // namespace cli
}  // namespace falko_slam
