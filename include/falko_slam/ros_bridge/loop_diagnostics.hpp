// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <map>
#include <string>

#include "falko_slam/place_recognition/loop_detector.hpp"
#include "falko_slam/sensor/scan_report.hpp"

namespace falko_slam {

/// Keeps count of what becomes of scans and of candidates for loops, for /diagnostics.
///
/// OK while scans come in and can be placed in tf. WARN without a scan for `timeout` seconds
/// (naming the topic), if scans had to be dropped for want of a transform since the last report, or
/// if no beam of the last scan was valid. ERROR if the last scan was unusable.
class LoopDiagnostics {
 public:
  explicit LoopDiagnostics(std::string topic, double timeout = 3.0);

  /// `now` [s]: steady clock.
  void received(const ScanReport& report, double now);
  /// A scan that tf could not place, and what it lacks.
  void dropped(const std::string& missing);
  /// A keyframe, after `duration` seconds of work.
  void added(KeyframeId keyframe, const LoopDetection& detection, double duration);
  /// Keyframes of a file have taken the place of all others.
  void loaded(std::size_t keyframes);

  std::size_t dropped_scans() const { return dropped_; }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status, double now);

 private:
  std::string topic_;
  double timeout_;
  double started_ = -1.0;
  double last_scan_ = -1.0;
  ScanReport last_;
  std::size_t scans_ = 0;
  std::size_t unusable_ = 0;
  std::size_t dropped_ = 0;
  std::string missing_;
  std::size_t keyframes_ = 0;
  std::size_t loaded_ = 0;
  std::size_t accepted_ = 0;
  std::string last_accepted_ = "none yet";
  std::map<LoopVerdict, std::size_t> verdicts_;

  struct Window {
    std::size_t dropped = 0;
    std::size_t keyframes = 0;
    double busy = 0.0;
    double longest = 0.0;
  };
  Window window_;
};

}  // namespace falko_slam
