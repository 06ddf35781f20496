// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_tally.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

namespace falko_slam {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

void ScanTally::received(const ScanReport& report, double now) {
  watch_.heard(now);
  last_ = report;
  ++scans_;
  if (!report.usable()) ++unusable_;
}

void ScanTally::dropped(const std::string& missing) {
  ++dropped_;
  ++dropped_in_window_;
  missing_ = missing;
}

std::string ScanTally::trouble_of_last() const {
  if (scans_ == 0) return "";
  if (last_.count(BeamStatus::kValid) == 0) return "no valid beam: " + describe(last_);
  if (last_.angles_disagree()) return "angles and number of beams disagree: " + describe(last_);
  return "";
}

void ScanTally::summarize(DiagnosticStatusWrapper& status, double now) {
  const std::string silence = watch_.trouble(now);
  const std::string strange = trouble_of_last();
  if (!silence.empty()) {
    status.summary(DiagnosticStatus::WARN, silence);
  } else if (scans_ > 0 && !last_.usable()) {
    status.summary(DiagnosticStatus::ERROR, "unusable scan: " + describe(last_));
  } else if (dropped_in_window_ > 0) {
    status.summaryf(DiagnosticStatus::WARN, "%zu scans dropped: %s", dropped_in_window_,
                    missing_.c_str());
  } else if (!strange.empty()) {
    status.summary(DiagnosticStatus::WARN, strange);
  }
}

void ScanTally::add_counts(DiagnosticStatusWrapper& status) const {
  status.add("topic", watch_.name());
  status.add("scans", scans_);
  status.add("scans unusable", unusable_);
  status.add("scans dropped for want of a transform", dropped_);
}

void ScanTally::add_last(DiagnosticStatusWrapper& status) const {
  status.add("last scan", scans_ > 0 ? describe(last_) : std::string("none yet"));
}

}  // namespace falko_slam
