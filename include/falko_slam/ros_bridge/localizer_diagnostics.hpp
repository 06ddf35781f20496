// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <string>
#include <utility>

#include "falko_slam/localization/localizer_report.hpp"
#include "falko_slam/ros_bridge/topic_watch.hpp"
#include "falko_slam/sensor/scan_report.hpp"

namespace falko_slam {

struct LocalizerDiagnosticsParams {
  double warn_position = 0.05;  ///< standard deviation [m]
  double warn_heading = 0.02;   ///< the same [rad]
};

/// Keeps count of what a localizer hears and says, for /diagnostics.
///
/// OK while its status is OK and the pose is known better than the limits. WARN while it is
/// DEGRADED or RECOVERING, when an input is silent, with its topic and the cause, or with
/// deviations beyond the limits. ERROR while it is LOST, or scans are unusable.
class LocalizerDiagnostics {
 public:
  /// `now`: steady time [s], here and below.
  LocalizerDiagnostics(const LocalizerDiagnosticsParams& params, TopicWatch motions,
                       TopicWatch scans, double now)
      : params_(params),
        motions_{std::move(motions)},
        scans_{std::move(scans)},
        last_report_(now) {}

  void moved(double now);
  void scanned(double now, double duration);
  void unusable(double now, const ScanReport& report);
  void refused(InputVerdict verdict);
  /// Additional warnings that stay until the next call; "" for none.
  void warn_of_mount(const std::string& warning) { mount_ = warning; }
  void warn_of_odometry(const std::string& warning) { odometry_ = warning; }
  void warn_of_pose_file(const std::string& warning) { pose_file_trouble_ = warning; }
  void note_pose_file(const std::string& text) { pose_file_ = text; }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status, double now,
              const LocalizerReport& state);

 private:
  struct Input {
    TopicWatch watch;
    std::size_t count = 0;  // since the last report
  };
  void summarize(diagnostic_updater::DiagnosticStatusWrapper& status, double now,
                 const LocalizerReport& state);
  void add_values(diagnostic_updater::DiagnosticStatusWrapper& status, double now,
                  const LocalizerReport& state) const;

  LocalizerDiagnosticsParams params_;
  Input motions_, scans_;
  double last_report_;
  std::size_t unusable_ = 0, refused_ = 0;
  std::string fault_, mount_, odometry_, pose_file_trouble_, pose_file_ = "none";
  double busy_ = 0.0, longest_ = 0.0;  // on scans, since the last report [s]
};

}  // namespace falko_slam
