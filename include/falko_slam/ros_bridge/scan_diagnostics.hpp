// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <string>

#include "falko_slam/ros_bridge/scan_tally.hpp"

namespace falko_slam {

/// Keeps count of the scans of a detector and what became of them, for /diagnostics.
///
/// OK while usable scans come in; else what ScanTally says. Rates and means are those since the
/// last report.
class ScanDiagnostics {
 public:
  /// `now` [s]: steady clock, here and below.
  ScanDiagnostics(TopicWatch scans, double now);

  /// After `duration` seconds of work.
  void add(const ScanReport& report, std::size_t keypoints, double now, double duration);
  /// An additional warning that stays until the next call; "" for none.
  void warn(const std::string& warning) { warning_ = warning; }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status, double now);

 private:
  ScanTally tally_;
  std::string warning_;
  std::size_t no_beams_ = 0;
  std::size_t bad_angles_ = 0;
  std::size_t invalid_beams_ = 0;

  struct Window {
    double start = 0.0;
    std::size_t scans = 0;
    std::size_t keypoints = 0;
    double busy = 0.0;
    double longest = 0.0;
  };
  Window window_;
};

}  // namespace falko_slam
