// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/calibration/calibrator.hpp"
#include "falko_slam/calibration/reflector_range.hpp"
#include "falko_slam/calibration/segment_recorder.hpp"

namespace falko_slam {

/// A calibration from what a SegmentRecorder cut out of a drive.
struct RecordedCalibration {
  CalibrationResult result;
  RangeOffset range_offset;           ///< of the scanner's reflectors, mended before; of scans: 0
  std::vector<std::size_t> recorded;  ///< which recorded segment each of result.segments is
};

/// The recorded segments that have no complaint, their reflectors' ranges mended by the offset that
/// fits all of them best, calibrated. The same online and from a recording. Egomotion from scans
/// needs no such mending: a wall that is seen too near is moved the same way at both ends.
///
/// How a reflector looks from a place does not average out (`lasting_noise` [m], as in
/// ReflectorMotionParams), and arcs of one phase begin and end in much the same directions: what
/// this does to their egomotion counts as common to the phase, unless `params.noise` says more. Of
/// walls it is ScanMotion::lasting_covariance that counts so.
/// Throws std::invalid_argument as calibrate() does.
RecordedCalibration calibrate_recorded(const std::vector<RecordedSegment>& recorded,
                                       const CalibratorParams& params, double lasting_noise);

}  // namespace falko_slam
