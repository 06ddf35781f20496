// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/calibration/segment_recorder.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

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
  std::string scans;       ///< sensor_msgs/LaserScan
};

/// What the bag offers egomotion from: reflectors, if half of their messages have at least
/// `min_reflectors`; else scans, if there are any. Throws std::runtime_error that names the file
/// and lists its topics if it has neither.
EgomotionSource egomotion_in(const std::string& bag, const CalibrationTopics& topics,
                             std::size_t min_reflectors);

/// Cuts the drive of a bag into segments as SegmentRecorder does, with the egomotion that `params`
/// asks for; `scanner` is about the scans. Throws std::runtime_error that
/// names the file, and lists its topics with their types if one is missing or not the only one.
CalibrationRecording read_calibration_drive(const std::string& bag, const CalibrationTopics& topics,
                                            const SegmentRecorderParams& params,
                                            const ScanNormalizerParams& scanner = {});

}  // namespace falko_slam
