// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <map>
#include <string>

#include "falko_slam/sensor/scan_report.hpp"
#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

/// Keeps count of what becomes of scans, keyframes and closures, for /diagnostics.
///
/// OK while scans come in, can be placed in tf and fit into the map. WARN, with the cause, without
/// a scan for `timeout` seconds, if since the last report scans had to be dropped for want of a
/// transform or of time, or fitted nowhere, if no beam of the last one was valid, while paused, and
/// while the drive's place in the map is not known. ERROR if the last scan was unusable or SLAM has
/// failed on one. The worst is told first.
class SlamDiagnostics {
 public:
  SlamDiagnostics(std::string topic, bool use_odometry, double timeout);

  /// Steady time, and that of the vehicle, which may run faster or stand still. [s]
  struct Clock {
    double steady = 0.0;
    double vehicle = 0.0;
  };

  void received(const ScanReport& report, const Clock& now);
  /// A scan that tf could not place, and what it lacks.
  void dropped(const std::string& missing);
  /// A scan had to go because others before it were not done.
  void overflowed();
  /// A scan that came while paused.
  void ignored() { ++ignored_; }
  void paused(bool is_paused) { paused_ = is_paused; }
  void failed(const std::string& error);
  /// A scan is done, after `duration` seconds of work.
  void processed(const SlamStep& step, double duration);
  /// The map was drawn in `duration` seconds.
  void drawn(std::size_t width, std::size_t height, double duration);
  /// All closures so far.
  void tally(std::size_t keyframes, const std::vector<SlamClosure>& closures);
  /// There is another map: what was counted of the old one is forgotten.
  void restarted(std::size_t keyframes);
  /// An additional warning that stays until the next call; "" for none.
  void warn(const std::string& warning) { warning_ = warning; }

  std::size_t dropped_scans() const { return dropped_; }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status, const Clock& now);

 private:
  struct Window {
    double start = -1.0;
    std::size_t received = 0;
    std::size_t processed = 0;
    std::size_t dropped = 0;
    std::size_t overflowed = 0;
    std::size_t lost = 0;
    double busy = 0.0;
    double longest = 0.0;
    std::string failure;
  };
  double silence(const Clock& now) const;
  void summarize(diagnostic_updater::DiagnosticStatusWrapper& status, const Clock& now) const;
  void add_counts(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void add_times(diagnostic_updater::DiagnosticStatusWrapper& status, const Clock& now) const;

  std::string topic_;
  bool use_odometry_;
  double timeout_;
  bool started_ = false;
  Clock last_;  // scan, or the first report
  ScanReport last_report_;
  std::string missing_, warning_;
  bool paused_ = false;
  bool anchored_ = false;
  std::size_t received_ = 0, unusable_ = 0, dropped_ = 0, overflowed_ = 0, ignored_ = 0;
  std::size_t processed_ = 0, lost_ = 0, searched_ = 0, failures_ = 0;
  std::size_t keyframes_ = 0, accepted_ = 0, optimizations_ = 0;
  std::string last_optimization_ = "none yet";
  std::string map_ = "none yet";
  std::map<std::string, std::size_t> refused_;
  Window window_;
};

}  // namespace falko_slam
