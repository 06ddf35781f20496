// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/calibration/segment_recorder.hpp"

namespace falko_slam {

/// The segments of a calibration drive that a bag holds.
struct CalibrationRecording {
  std::vector<RecordedSegment> segments;
  std::string description;  ///< one line: what was read
};

/// Which topics of a bag; empty: the only one of its type.
struct CalibrationTopics {
  std::string encoders;    ///< falko_slam/TricycleEncoders
  std::string reflectors;  ///< falko_slam/ReflectorArray
};

/// Cuts the drive of a bag into segments as SegmentRecorder does. Throws std::runtime_error that
/// names the file, and lists its topics with their types if one is missing or not the only one.
CalibrationRecording read_calibration_drive(const std::string& bag, const CalibrationTopics& topics,
                                            const SegmentRecorderParams& params);

}  // namespace falko_slam
