// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/reflector_calibration.hpp"

namespace falko_slam {

ReflectorCalibration calibrate_recorded(const std::vector<RecordedSegment>& recorded,
                                        const CalibratorParams& params) {
  ReflectorCalibration calibration;
  std::vector<ReflectorMotion> motions;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (!recorded[i].complaint.empty()) continue;
    calibration.recorded.push_back(i);
    motions.push_back(recorded[i].motion);
  }
  calibration.range_offset = estimate_range_offset(motions);
  std::vector<PathSegment> segments;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const ReflectorMotion mended = with_range_offset(motions[i], calibration.range_offset.offset);
    PathSegment segment = recorded[calibration.recorded[i]].segment;
    segment.start_T_end = mended.start_T_end;
    segment.turn = mended.turn;
    segments.push_back(segment);
  }
  calibration.result = calibrate(segments, params);
  return calibration;
}

}  // namespace falko_slam
