// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <utility>

namespace falko_slam {

using diagnostic_msgs::DiagnosticStatus;

ScanDiagnostics::ScanDiagnostics(TopicWatch scans, double now) : tally_(std::move(scans)) {
  window_.start = now;
}

void ScanDiagnostics::add(const ScanReport& report, std::size_t keypoints, double now,
                          double duration) {
  tally_.received(report, now);
  if (report.fault == ScanFault::kNoBeams) ++no_beams_;
  if (report.fault == ScanFault::kBadAngles) ++bad_angles_;
  if (report.usable()) {
    invalid_beams_ += report.beam_count - report.surplus_beams - report.count(BeamStatus::kValid);
  }
  ++window_.scans;
  window_.keypoints += keypoints;
  window_.busy += duration;
  window_.longest = std::max(window_.longest, duration);
}

void ScanDiagnostics::report(diagnostic_updater::DiagnosticStatusWrapper& status, double now) {
  const double seconds = now - window_.start;
  const auto scans = static_cast<double>(window_.scans);
  const double rate = seconds > 0.0 ? scans / seconds : 0.0;
  const double keypoints = window_.scans > 0 ? static_cast<double>(window_.keypoints) / scans : 0.0;

  status.summaryf(DiagnosticStatus::OK, "%.1f scans/s, %.1f keypoints each", rate, keypoints);
  if (!warning_.empty()) status.summary(DiagnosticStatus::WARN, warning_);
  tally_.summarize(status, now);

  tally_.add_counts(status);
  status.add("dropped: no beams", no_beams_);
  status.add("dropped: bad angles", bad_angles_);
  status.add("invalid beams in used scans", invalid_beams_);
  status.addf("rate [1/s]", "%.2f", rate);
  status.addf("keypoints per scan", "%.2f", keypoints);
  status.addf("time per scan, mean [ms]", "%.3f", scans > 0.0 ? 1e3 * window_.busy / scans : 0.0);
  status.addf("time per scan, longest [ms]", "%.3f", 1e3 * window_.longest);
  tally_.add_last(status);
  tally_.begin_window();
  window_ = Window{};
  window_.start = now;
}

}  // namespace falko_slam
