// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "falko_slam/place_recognition/loop_detector.hpp"
#include "falko_slam/ros_bridge/scan_tally.hpp"

namespace falko_slam {

/// Keeps count of what becomes of scans and of candidates for loops, for /diagnostics.
///
/// OK while scans come in and can be placed in tf; else what ScanTally says.
class LoopDiagnostics {
 public:
  explicit LoopDiagnostics(TopicWatch scans) : tally_(std::move(scans)) {}

  /// `now` [s]: steady clock.
  void received(const ScanReport& report, double now) { tally_.received(report, now); }
  /// A scan that tf could not place, and what it lacks.
  void dropped(const std::string& missing) { tally_.dropped(missing); }
  /// A keyframe, after `duration` seconds of work.
  void added(KeyframeId keyframe, const LoopDetection& detection, double duration);
  /// Keyframes of a file have taken the place of all others.
  void loaded(std::size_t keyframes);

  std::size_t dropped_scans() const { return tally_.dropped_scans(); }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status, double now);

 private:
  ScanTally tally_;
  std::size_t keyframes_ = 0;
  std::size_t loaded_ = 0;
  std::size_t accepted_ = 0;
  std::string last_accepted_ = "none yet";
  std::map<LoopVerdict, std::size_t> verdicts_;

  struct Window {
    std::size_t keyframes = 0;
    double busy = 0.0;
    double longest = 0.0;
  };
  Window window_;
};

}  // namespace falko_slam
