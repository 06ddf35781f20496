// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/keyframe_memory.hpp"

#include <utility>

namespace falko_slam {

void validate(const LoopClosureParams& params) {
  validate(params.scan);
  validate(params.selector);
  validate(params.detector);
}

KeyframeMemory::KeyframeMemory(const LoopClosureParams& params,
                               const std::vector<KeyframeRecord>& records)
    : detector_((validate(params), params.detector)) {
  for (const KeyframeRecord& record : records) {
    if (!records_.empty() && record.drive != records_.back().drive) begin_drive();
    add(record);
  }
  begin_drive();
}

KeyframeId KeyframeMemory::add(KeyframeRecord record) {
  const KeyframeId id = detector_.add(record.scan, record.odom_T_laser);
  record.drive = drive_;
  record.scan.intensities.clear();
  records_.push_back(std::move(record));
  return id;
}

void KeyframeMemory::begin_drive() {
  detector_.begin_drive();
  drive_ = records_.empty() ? 0 : records_.back().drive + 1;
}

}  // namespace falko_slam
