// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/place_recognition/keyframe_memory.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace test {

/// Three keyframes of a room, the last one of another drive whose odometry started 10 m off.
inline KeyframeMemory room_memory() {
  auto random = seeded_random();
  KeyframeMemory memory({});
  for (std::int64_t i = 0; i < 3; ++i) {
    const Pose2 pose(0.3 * static_cast<double>(i) - 1.0, -0.5, 0.4);
    if (i == 2) memory.begin_drive();
    KeyframeRecord record;
    record.stamp = Time(std::chrono::seconds(100 + i));
    record.odom_T_laser = Pose2(i == 2 ? 10.0 : 0.0, 0.0, 0.0) * pose;
    record.base_T_laser = {0.5, 0.0, 0.1};
    record.scan = closed_scan(room_with_pillar(), pose, 360, 0.01, random);
    memory.add(record);
  }
  return memory;
}

/// The loop of keyframe 2 with keyframe 0, and candidates that were refused.
inline LoopDetection room_loop() {
  const auto estimate = [](const Pose2& pose) {
    PoseEstimate result;
    result.pose = pose;
    return result;
  };
  LoopDetection detection;
  detection.candidates.resize(3);
  detection.candidates[0].target = {0};
  detection.candidates[0].verdict = LoopVerdict::kAccepted;
  detection.candidates[0].score = 0.8;
  detection.candidates[0].scan_score = 0.9;
  detection.candidates[0].pairs = 7;
  detection.candidates[0].signature_distance = 123;
  detection.candidates[0].rms_residual = 0.02;
  detection.candidates[0].target_T_source = estimate({0.6, 0.1, 0.0});
  detection.candidates[1].target = {1};
  detection.candidates[1].verdict = LoopVerdict::kLowScore;
  detection.candidates[1].score = 0.2;
  detection.candidates[1].target_T_source = estimate({-0.6, 0.1, 0.0});
  detection.candidates[2].target = {1};
  detection.candidates[2].verdict = LoopVerdict::kNotMatched;
  return detection;
}

}  // namespace test
}  // namespace falko_slam
