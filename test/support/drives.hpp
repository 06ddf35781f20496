// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "falko_slam/evaluation/posed_scan.hpp"
#include "falko_slam/place_recognition/loop_detector.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace test {

using Poses = std::vector<Pose2>;

/// One way after the other.
inline Poses joined(Poses first, const Poses& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// From a pose straight ahead, or backwards if `length` is negative.
inline Poses straight(const Pose2& from, double length, double step) {
  Poses path;
  const auto count = static_cast<int>(std::floor(std::abs(length) / step + 1e-9));
  for (int i = 0; i <= count; ++i) {
    path.push_back(from * Pose2(std::copysign(step * i, length), 0.0, 0.0));
  }
  return path;
}

/// What a closed laser sees on its way, with noise of 1 cm.
inline std::vector<PosedScan> drive(const Scene& scene, const Poses& path, std::mt19937_64& random,
                                    std::size_t beams = 360) {
  std::vector<PosedScan> scans;
  for (const Pose2& pose : path) {
    scans.push_back({closed_scan(scene, pose, beams, 0.01, random), pose});
  }
  return scans;
}

inline LoopDetector detector_of(const std::vector<PosedScan>& scans,
                                const LoopDetectorParams& params = {}) {
  LoopDetector detector(params);
  for (const PosedScan& scan : scans) detector.add(scan.scan, scan.map_T_laser);
  return detector;
}

/// The loops of all keyframes, by their ids.
inline std::vector<LoopDetection> detect_all(LoopDetector& detector) {
  std::vector<LoopDetection> detections;
  for (std::size_t id = 0; id < detector.keyframes().size(); ++id) {
    detections.push_back(detector.detect({id}));
  }
  return detections;
}

/// The error of `target_T_source` where the keyframes' poses are the true ones.
inline Pose2 error_of(const Keyframe& target, const Pose2& source_pose,
                      const Pose2& target_T_source) {
  return (target.odom_T_laser * target_T_source).inverse() * source_pose;
}

/// Within 0.1 m and 2 degrees.
inline bool is_right(const Keyframe& target, const Pose2& source_pose,
                     const Pose2& target_T_source) {
  const Pose2 error = error_of(target, source_pose, target_T_source);
  return error.translation().norm() < 0.1 && std::abs(error.theta()) < degrees_to_radians(2.0);
}

}  // namespace test
}  // namespace falko_slam
