// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "falko_slam/ros_bridge/scan_tally.hpp"
#include "falko_slam/slam/feature_slam.hpp"

namespace falko_slam {

/// Keeps count of what becomes of scans, keyframes and closures, for /diagnostics.
///
/// OK while scans come in, can be placed in tf and fit into the map. WARN, with the cause, if since
/// the last report scans were dropped for want of time or fitted nowhere, while paused, while the
/// drive's place in the map is not known, and without a scan for `timeout` seconds of the vehicle's
/// time, which may run faster than ours. More important is what ScanTally says, and most, an ERROR,
/// that SLAM has failed on a scan.
class SlamDiagnostics {
 public:
  SlamDiagnostics(TopicWatch scans, bool use_odometry, double timeout);

  /// Steady time, and that of the vehicle, which may run faster or stand still. [s]
  struct Clock {
    double steady = 0.0;
    double vehicle = 0.0;
  };

  void received(const ScanReport& report, const Clock& now);
  /// A scan that tf could not place, and what it lacks.
  void dropped(const std::string& missing) { tally_.dropped(missing); }
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

  std::size_t dropped_scans() const { return tally_.dropped_scans(); }
  void report(diagnostic_updater::DiagnosticStatusWrapper& status, const Clock& now);

 private:
  struct Window {
    double start = -1.0;
    std::size_t received = 0;
    std::size_t processed = 0;
    std::size_t overflowed = 0;
    std::size_t lost = 0;
    double busy = 0.0;
    double longest = 0.0;
    std::string failure;
  };
  void summarize(diagnostic_updater::DiagnosticStatusWrapper& status, const Clock& now);
  /// Without a scan, by the faster of the two clocks [s].
  double silence(const Clock& now) const;
  void add_counts(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void add_times(diagnostic_updater::DiagnosticStatusWrapper& status, const Clock& now) const;

  ScanTally tally_;
  bool use_odometry_;
  double timeout_;
  std::optional<double> last_;  // scan, or the first report, by the vehicle's time [s]
  std::string warning_;
  bool paused_ = false;
  bool anchored_ = false;
  std::size_t overflowed_ = 0, ignored_ = 0;
  std::size_t processed_ = 0, lost_ = 0, searched_ = 0, failures_ = 0;
  std::size_t keyframes_ = 0, accepted_ = 0, optimizations_ = 0;
  std::string last_optimization_ = "none yet";
  std::string map_ = "none yet";
  std::map<std::string, std::size_t> refused_;
  Window window_;
};

}  // namespace falko_slam
