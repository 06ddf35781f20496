// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/evaluation/loop_method.hpp"
#include "falko_slam/place_recognition/loop_detector.hpp"

namespace falko_slam {

/// Our loop detector on a log: every scan is a keyframe, the corrected pose is its odometry.
class DetectorRun {
 public:
  explicit DetectorRun(const std::vector<PosedScan>& scans, const LoopDetectorParams& params = {});

  /// Closes all scans, best candidate by score, and tells what the detector accepts by itself.
  LoopMethodResult close_all(const LoopTruth& truth);

  LoopDetector& detector() { return detector_; }

 private:
  LoopDetector detector_;
  LoopTiming creation_;
};

}  // namespace falko_slam
