// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <string>

#include "falko_slam/localization/localizer_report.hpp"
#include "falko_slam/sensor/scan_report.hpp"

namespace falko_slam {

struct LocalizerDiagnosticsParams {
  double input_timeout = 1.0;   ///< [s]
  double warn_position = 0.05;  ///< standard deviation [m]
  double warn_heading = 0.02;   ///< the same [rad]
};

/// An input as its subscriber sees it.
struct InputState {
  std::string topic;
  std::size_t publishers = 0;
};

/// Keeps count of what a localizer hears and says, for /diagnostics.
///
/// OK while its status is OK and the pose is known better than the limits. WARN while it is
/// DEGRADED or RECOVERING, when an input is silent, with its topic and whether anybody publishes
/// it, or with deviations beyond the limits. ERROR while it is LOST, or scans are unusable.
class LocalizerDiagnostics {
 public:
  /// `now`: steady time [s], here and below.
  LocalizerDiagnostics(const LocalizerDiagnosticsParams& params, double now)
      : params_(params), started_(now), last_report_(now) {}

  void moved(double now);
  void scanned(double now, double duration);
  void unusable(const ScanReport& report);
  void refused(InputVerdict verdict);
  /// An additional warning that stays until the next call; "" for none.
  void warn(const std::string& warning) { warning_ = warning; }
  void note_pose_file(const std::string& text) { pose_file_ = text; }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status, double now,
              const LocalizerReport& state, const InputState& motions, const InputState& scans);

 private:
  struct Input {
    double last = -1.0;     // steady time [s]
    std::size_t count = 0;  // since the last report
  };
  std::string silence_of(const Input& input, const InputState& state, double now) const;
  void summarize(diagnostic_updater::DiagnosticStatusWrapper& status, double now,
                 const LocalizerReport& state, const InputState& motions,
                 const InputState& scans) const;
  void add_values(diagnostic_updater::DiagnosticStatusWrapper& status, double now,
                  const LocalizerReport& state) const;

  LocalizerDiagnosticsParams params_;
  double started_, last_report_;
  Input motions_, scans_;
  std::size_t unusable_ = 0, refused_ = 0;
  std::string fault_, warning_, pose_file_ = "none";
  double busy_ = 0.0, longest_ = 0.0;  // on scans, since the last report [s]
};

}  // namespace falko_slam
