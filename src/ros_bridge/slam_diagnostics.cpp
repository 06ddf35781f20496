// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/slam_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace falko_slam {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

SlamDiagnostics::SlamDiagnostics(std::string topic, bool use_odometry, double timeout)
    : topic_(std::move(topic)), use_odometry_(use_odometry), timeout_(timeout) {}

void SlamDiagnostics::received(const ScanReport& report, const Clock& now) {
  last_report_ = report;
  last_ = now;
  started_ = true;
  ++received_;
  ++window_.received;
  if (!report.usable()) ++unusable_;
}

void SlamDiagnostics::dropped(const std::string& missing) {
  ++dropped_;
  ++window_.dropped;
  missing_ = missing;
}

void SlamDiagnostics::overflowed() {
  ++overflowed_;
  ++window_.overflowed;
}

void SlamDiagnostics::failed(const std::string& error) {
  ++failures_;
  window_.failure = error;
}

void SlamDiagnostics::processed(const SlamStep& step, double duration) {
  ++processed_;
  ++window_.processed;
  window_.busy += duration;
  window_.longest = std::max(window_.longest, duration);
  anchored_ = step.anchored;
  keyframes_ += step.is_keyframe ? 1U : 0U;
  lost_ += step.lost ? 1U : 0U;
  window_.lost += step.lost ? 1U : 0U;
  searched_ += step.searched ? 1U : 0U;
  if (!step.optimized) return;
  ++optimizations_;
  last_optimization_ = "at keyframe " + std::to_string(step.keyframe ? step.keyframe->value : 0);
}

void SlamDiagnostics::drawn(std::size_t width, std::size_t height, double duration) {
  char text[96];
  std::snprintf(text, sizeof text, "%zu x %zu cells, drawn in %.1f ms", width, height,
                1e3 * duration);
  map_ = text;
}

void SlamDiagnostics::tally(std::size_t keyframes, const std::vector<SlamClosure>& closures) {
  keyframes_ = keyframes;
  accepted_ = 0;
  refused_.clear();
  for (const SlamClosure& closure : closures) {
    closure.accepted ? ++accepted_ : ++refused_[closure.verdict];
  }
}

void SlamDiagnostics::restarted(std::size_t keyframes) {
  tally(keyframes, {});
  anchored_ = false;
  optimizations_ = 0;
  last_optimization_ = "none yet";
  map_ = "none yet";
}

double SlamDiagnostics::silence(const Clock& now) const {
  return std::max(now.steady - last_.steady, now.vehicle - last_.vehicle);
}

void SlamDiagnostics::summarize(DiagnosticStatusWrapper& status, const Clock& now) const {
  status.summaryf(DiagnosticStatus::OK, "%zu keyframes, %zu closures%s", keyframes_, accepted_,
                  use_odometry_ ? "" : ", without odometry");
  const auto warn = [&](const std::string& text) { status.summary(DiagnosticStatus::WARN, text); };
  if (keyframes_ > 0 && !anchored_) warn("the drive's place in the map is not known yet");
  if (!warning_.empty()) warn(warning_);
  if (window_.lost > 0) {
    warn(std::to_string(window_.lost) + " scans fitted nowhere" +
         (use_odometry_ ? ", odometry alone was believed" : ""));
  }
  if (received_ > 0 && last_report_.usable() && last_report_.count(BeamStatus::kValid) == 0) {
    warn("no valid beam: " + describe(last_report_));
  }
  if (window_.overflowed > 0) {
    warn(std::to_string(window_.overflowed) +
         " scans dropped: they come faster than they are done");
  }
  if (paused_) warn("paused");
  if (window_.dropped > 0) warn(std::to_string(window_.dropped) + " scans dropped: " + missing_);
  if (silence(now) > timeout_) {
    status.summaryf(DiagnosticStatus::WARN, "no scan on %s for %.1f s", topic_.c_str(),
                    silence(now));
  }
  if (received_ > 0 && !last_report_.usable()) {
    status.summary(DiagnosticStatus::ERROR, "unusable scan: " + describe(last_report_));
  }
  if (!window_.failure.empty()) status.summary(DiagnosticStatus::ERROR, window_.failure);
}

void SlamDiagnostics::add_counts(DiagnosticStatusWrapper& status) const {
  status.add("topic", topic_);
  status.add("odometry", use_odometry_ ? "used" : "not used: scans alone");
  status.add("anchored in the map", anchored_ ? "yes" : "no");
  status.add("scans", received_);
  status.add("scans unusable", unusable_);
  status.add("scans dropped for want of a transform", dropped_);
  status.add("scans dropped for want of time", overflowed_);
  status.add("scans ignored while paused", ignored_);
  status.add("scans failed on", failures_);
  status.add("scans that fitted nowhere", lost_);
  status.add("scans searched for", searched_);
  status.add("keyframes", keyframes_);
  status.add("closures accepted", accepted_);
  for (const auto& [verdict, count] : refused_) {
    status.add("closures not accepted: " + verdict, count);
  }
  status.add("optimizations", optimizations_);
  status.add("last optimization", last_optimization_);
  status.add("map", map_);
}

void SlamDiagnostics::add_times(DiagnosticStatusWrapper& status, const Clock& now) const {
  const double seconds = now.steady - window_.start;
  const auto processed = static_cast<double>(window_.processed);
  status.addf("rate of scans [1/s]", "%.2f",
              seconds > 0.0 ? static_cast<double>(window_.received) / seconds : 0.0);
  status.addf("time since the last scan [s]", "%.2f", silence(now));
  status.addf("time per scan, mean [ms]", "%.3f",
              window_.processed > 0 ? 1e3 * window_.busy / processed : 0.0);
  status.addf("time per scan, longest [ms]", "%.3f", 1e3 * window_.longest);
  status.add("last scan", received_ > 0 ? describe(last_report_) : std::string("none yet"));
}

void SlamDiagnostics::report(DiagnosticStatusWrapper& status, const Clock& now) {
  if (!started_) last_ = now;
  started_ = true;
  last_.vehicle = std::min(last_.vehicle, now.vehicle);  // which may have jumped back
  if (window_.start < 0.0) window_.start = last_.steady;
  summarize(status, now);
  add_counts(status);
  add_times(status, now);
  window_ = Window{};
  window_.start = now.steady;
}

}  // namespace falko_slam
