// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "falko_slam/place_recognition/keyframe_file.hpp"
#include "falko_slam/place_recognition/keyframe_selector.hpp"
#include "falko_slam/place_recognition/loop_detector.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {

/// All that the loop closure nodelet is set up with.
struct LoopClosureParams {
  ScanNormalizerParams scan;
  KeyframeSelectorParams selector;
  LoopDetectorParams detector;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LoopClosureParams& params);

/// The keyframes of all drives: to find loops and places among them, to save and to load.
///
/// Ids are positions in records(). Not thread-safe.
class KeyframeMemory {
 public:
  /// With the keyframes of a file, if any; what is added afterwards is another drive.
  /// Throws std::invalid_argument if parameters are wrong.
  explicit KeyframeMemory(const LoopClosureParams& params,
                          const std::vector<KeyframeRecord>& records = {});

  /// `record.drive` is left to the memory.
  KeyframeId add(KeyframeRecord record);
  /// The odometry of the keyframes to come has nothing to do with that of those before.
  void begin_drive();
  /// That the next keyframe will belong to.
  std::size_t drive() const { return drive_; }

  /// The loops of a keyframe that has been added.
  LoopDetection detect(KeyframeId id, const LoopDetector::PoseAdmission& possible = {}) {
    return detector_.detect(id, {}, possible);
  }
  /// See LoopDetector::locate().
  std::vector<LoopCandidate> locate(const LaserScan& scan, std::size_t count) {
    return detector_.locate(scan, count);
  }

  const std::vector<KeyframeRecord>& records() const { return records_; }
  const KeyframeRecord& record(KeyframeId id) const { return records_.at(id.value); }
  const Keyframe& keyframe(KeyframeId id) const { return detector_.keyframes().at(id.value); }

 private:
  LoopDetector detector_;
  std::vector<KeyframeRecord> records_;
  std::size_t drive_ = 0;
};

}  // namespace falko_slam
