// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <variant>
#include <vector>

#include "falko_slam/calibration/segment_recorder.hpp"

namespace falko_slam {

/// A SegmentRecorder with a thread of its own: an arc may take some tenths of a second to evaluate,
/// and the vehicle must not wait for it.
class SegmentWorker {
 public:
  explicit SegmentWorker(const SegmentRecorderParams& params);
  ~SegmentWorker();

  void add(const EncoderReading& reading) { put(reading); }
  void add(const ReflectorObservation& observation) { put(observation); }
  void add(const ScanObservation& observation) { put(observation); }

  /// Waits until all that came in has been looked at.
  void catch_up();
  /// The same, and the drive is over.
  void finish();
  /// What has been completed since the last call.
  std::vector<RecordedSegment> take();

 private:
  using Input = std::variant<EncoderReading, ReflectorObservation, ScanObservation>;

  void put(Input input);
  void work();

  std::mutex mutex_;  // of the following
  std::condition_variable changed_;
  std::deque<Input> inputs_;
  std::vector<RecordedSegment> done_;
  bool busy_ = false;
  bool stop_ = false;

  SegmentRecorder recorder_;  // of whoever is busy
  std::thread thread_;
};

}  // namespace falko_slam
