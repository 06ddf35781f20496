// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <string>

#include "falko_slam/sensor/scan_report.hpp"

namespace falko_slam {

/// Keeps count of the scans of a detector and what became of them, for /diagnostics.
///
/// OK while usable scans come in. WARN without a scan for `timeout` seconds (naming the topic), if
/// no beam of the last scan was valid, or if count of beams and angles disagree. ERROR if the last
/// scan was unusable. Rates and means are those since the last report.
class ScanDiagnostics {
 public:
  explicit ScanDiagnostics(std::string topic, double timeout = 3.0);

  /// `now` and `duration` [s]: steady clock, time spent on this scan.
  void add(const ScanReport& report, std::size_t keypoints, double now, double duration);
  /// An additional warning that stays until the next call; "" for none.
  void warn(const std::string& warning) { warning_ = warning; }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status, double now);

 private:
  std::string topic_;
  double timeout_;
  double started_ = -1.0;
  double last_scan_ = -1.0;
  std::string warning_;
  ScanReport last_;
  std::size_t scans_ = 0;
  std::size_t no_beams_ = 0;
  std::size_t bad_angles_ = 0;
  std::size_t invalid_beams_ = 0;

  struct Window {
    double start = -1.0;
    std::size_t scans = 0;
    std::size_t keypoints = 0;
    double busy = 0.0;
    double longest = 0.0;
  };
  Window window_;
};

}  // namespace falko_slam
