// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/ros_bridge/localizer_conversion.hpp"

namespace falko_slam {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

void LocalizerDiagnostics::moved(double now) {
  motions_.watch.heard(now);
  ++motions_.count;
}

void LocalizerDiagnostics::scanned(double now, double duration) {
  scans_.watch.heard(now);
  ++scans_.count;
  busy_ += duration;
  longest_ = std::max(longest_, duration);
}

void LocalizerDiagnostics::unusable(double now, const ScanReport& report) {
  scans_.watch.heard(now);
  ++unusable_;
  fault_ = "unusable scan: " + describe(report);
}

void LocalizerDiagnostics::refused(InputVerdict verdict) {
  if (verdict != InputVerdict::kInOrder && verdict != InputVerdict::kLate) ++refused_;
}

void LocalizerDiagnostics::summarize(DiagnosticStatusWrapper& status, double now,
                                     const LocalizerReport& state) {
  status.summary(DiagnosticStatus::OK, std::string("localized: ") + name_of(state.status));
  const auto warn = [&](const std::string& text) {
    if (!text.empty()) status.mergeSummary(DiagnosticStatus::WARN, text);
  };
  const std::string words = std::string(name_of(state.status)) + ": " + describe(state.reason);
  if (state.status == LocalizationStatus::kLost) status.summary(DiagnosticStatus::ERROR, words);
  if (state.status == LocalizationStatus::kDegraded ||
      state.status == LocalizationStatus::kRecovering) {
    status.summary(DiagnosticStatus::WARN, words);
  }
  if (!fault_.empty()) status.mergeSummary(DiagnosticStatus::ERROR, fault_);
  warn(motions_.watch.trouble(now));
  warn(scans_.watch.trouble(now));
  warn(mount_);
  warn(odometry_);
  warn(pose_file_trouble_);
  if (!state.map_T_base) return;
  const Eigen::Vector3d deviations = deviations_of(*state.map_T_base);
  const double position = std::max(deviations(0), deviations(1));
  if (position > params_.warn_position) {
    warn("standard deviation of " + fixed_text(position, 3) + " m, more than " +
         fixed_text(params_.warn_position, 3));
  }
  if (deviations(2) > params_.warn_heading) {
    warn("standard deviation of the heading of " + fixed_text(deviations(2), 4) +
         " rad, more than " + fixed_text(params_.warn_heading, 4));
  }
}

void LocalizerDiagnostics::add_values(DiagnosticStatusWrapper& status, double now,
                                      const LocalizerReport& state) const {
  const double seconds = now - last_report_;
  const auto rate = [&](const Input& input) {
    return seconds > 0.0 ? static_cast<double>(input.count) / seconds : 0.0;
  };
  status.add("status", name_of(state.status));
  status.add("reason", name_of(state.reason));
  status.addf("rate of motions [1/s]", "%.1f", rate(motions_));
  status.addf("rate of scans [1/s]", "%.1f", rate(scans_));
  status.addf("time since the last scan [s]", "%.2f", scans_.watch.silence(now));
  status.add("landmarks observed", state.seen.size());
  status.add("landmarks matched", state.agreement.used);
  status.add("landmarks expected", state.agreement.expected);
  status.add("landmarks missed", state.agreement.missed);
  if (state.map_T_base) {
    const Eigen::Vector3d deviations = deviations_of(*state.map_T_base);
    status.addf("deviation along [m]", "%.4f", deviations(0));
    status.addf("deviation across [m]", "%.4f", deviations(1));
    status.addf("deviation of the heading [rad]", "%.5f", deviations(2));
  }
  status.addf("evidence", "%.1f", state.evidence);
  status.add("places compared", state.hypotheses);
  status.add("scans unusable", unusable_);
  status.add("inputs refused", refused_);
  const auto scans = static_cast<double>(std::max<std::size_t>(scans_.count, 1));
  status.addf("time per scan, mean [ms]", "%.2f", 1e3 * busy_ / scans);
  status.addf("time per scan, longest [ms]", "%.2f", 1e3 * longest_);
  status.add("pose file", pose_file_);
}

void LocalizerDiagnostics::report(DiagnosticStatusWrapper& status, double now,
                                  const LocalizerReport& state) {
  summarize(status, now, state);
  add_values(status, now, state);
  last_report_ = now;
  motions_.count = scans_.count = 0;
  busy_ = longest_ = 0.0;
  fault_.clear();
}

}  // namespace falko_slam
