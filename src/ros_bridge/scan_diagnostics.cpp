// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <utility>

namespace falko_slam {

using diagnostic_msgs::DiagnosticStatus;

ScanDiagnostics::ScanDiagnostics(std::string topic, double timeout)
    : topic_(std::move(topic)), timeout_(timeout) {}

void ScanDiagnostics::add(const ScanReport& report, std::size_t keypoints, double now,
                          double duration) {
  last_ = report;
  last_scan_ = now;
  ++scans_;
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
  if (started_ < 0.0) started_ = now;
  if (window_.start < 0.0) window_.start = started_;
  const double seconds = now - window_.start;
  const auto scans = static_cast<double>(window_.scans);
  const double rate = seconds > 0.0 ? scans / seconds : 0.0;
  const double keypoints = window_.scans > 0 ? static_cast<double>(window_.keypoints) / scans : 0.0;
  const double silence = now - (last_scan_ < 0.0 ? started_ : last_scan_);

  status.summaryf(DiagnosticStatus::OK, "%.1f scans/s, %.1f keypoints each", rate, keypoints);
  if (!warning_.empty()) status.summary(DiagnosticStatus::WARN, warning_);
  if (scans_ > 0 && last_.usable() && last_.count(BeamStatus::kValid) == 0) {
    status.summary(DiagnosticStatus::WARN, "no valid beam: " + describe(last_));
  } else if (scans_ > 0 && last_.angles_disagree()) {
    status.summary(DiagnosticStatus::WARN,
                   "angles and number of beams disagree: " + describe(last_));
  }
  if (scans_ > 0 && !last_.usable()) {
    status.summary(DiagnosticStatus::ERROR, "unusable scan: " + describe(last_));
  }
  if (silence > timeout_) {
    status.summaryf(DiagnosticStatus::WARN, "no scan on %s for %.1f s", topic_.c_str(), silence);
  }

  status.add("topic", topic_);
  status.add("scans", scans_);
  status.add("dropped: no beams", no_beams_);
  status.add("dropped: bad angles", bad_angles_);
  status.add("invalid beams in used scans", invalid_beams_);
  status.addf("rate [1/s]", "%.2f", rate);
  status.addf("keypoints per scan", "%.2f", keypoints);
  status.addf("time per scan, mean [ms]", "%.3f", scans > 0.0 ? 1e3 * window_.busy / scans : 0.0);
  status.addf("time per scan, longest [ms]", "%.3f", 1e3 * window_.longest);
  status.add("last scan", scans_ > 0 ? describe(last_) : std::string("none yet"));
  window_ = Window{};
  window_.start = now;
}

}  // namespace falko_slam
