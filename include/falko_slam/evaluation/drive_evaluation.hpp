// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/evaluation/driven_scan.hpp"
#include "falko_slam/evaluation/loop_protocol.hpp"
#include "falko_slam/place_recognition/keyframe_memory.hpp"

namespace falko_slam {

/// What the loop detector is told of where its keyframes are.
enum class DrivePoses {
  kCorrected,   ///< the truth, its steps mended by ScanOdometry too
  kOdometry,    ///< as it was recorded
  kRegistered,  ///< the odometry mended by ScanOdometry: what the nodelet does
};
const char* name_of(DrivePoses poses);

struct DriveResult {
  DrivePoses poses = DrivePoses::kCorrected;
  std::size_t keyframes = 0;
  std::size_t loops = 0;        ///< keyframes with a loop to be found (LoopProtocol::kRevisits)
  LoopOperatingPoint accepted;  ///< what the detector accepts
  std::size_t ambiguous = 0;    ///< keyframes whose best loop it refused as ambiguous
  double surest_refused = 0.0;  ///< greatest score of a wrong best candidate that was refused
};

/// Drives through the log as the loop closure nodelet does: keyframes by the odometry (or the
/// truth), each of them compared with all before.
DriveResult evaluate_drive(const std::vector<DrivenScan>& scans, DrivePoses poses,
                           const LoopClosureParams& params = {},
                           const LoopProtocolParams& protocol = {});

}  // namespace falko_slam
