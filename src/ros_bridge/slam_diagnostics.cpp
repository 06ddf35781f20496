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

SlamDiagnostics::SlamDiagnostics(TopicWatch scans, bool use_odometry, double timeout)
    : tally_(std::move(scans)), use_odometry_(use_odometry), timeout_(timeout) {}

void SlamDiagnostics::received(const ScanReport& report, const Clock& now) {
  tally_.received(report, now.steady);
  last_ = now.vehicle;
  ++window_.received;
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
  return std::max(tally_.watch().silence(now.steady), now.vehicle - *last_);
}

void SlamDiagnostics::summarize(DiagnosticStatusWrapper& status, const Clock& now) {
  status.summaryf(DiagnosticStatus::OK, "%zu keyframes, %zu closures%s", keyframes_, accepted_,
                  use_odometry_ ? "" : ", without odometry");
  const auto warn = [&](const std::string& text) { status.summary(DiagnosticStatus::WARN, text); };
  if (keyframes_ > 0 && !anchored_) warn("the drive's place in the map is not known yet");
  if (window_.lost > 0) {
    warn(std::to_string(window_.lost) + " scans fitted nowhere" +
         (use_odometry_ ? ", odometry alone was believed" : ""));
  }
  if (window_.overflowed > 0) {
    warn(std::to_string(window_.overflowed) +
         " scans dropped: they come faster than they are done");
  }
  if (paused_) warn("paused");
  if (silence(now) > timeout_) warn(tally_.watch().describe(silence(now)));
  tally_.summarize(status, now.steady);
  // Has nothing to do with the scans, and is not to be hidden by them.
  if (!warning_.empty()) status.mergeSummary(DiagnosticStatus::WARN, warning_);
  if (!window_.failure.empty()) status.summary(DiagnosticStatus::ERROR, window_.failure);
}

void SlamDiagnostics::add_counts(DiagnosticStatusWrapper& status) const {
  tally_.add_counts(status);
  status.add("odometry", use_odometry_ ? "used" : "not used: scans alone");
  status.add("anchored in the map", anchored_ ? "yes" : "no");
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
  tally_.add_last(status);
}

void SlamDiagnostics::report(DiagnosticStatusWrapper& status, const Clock& now) {
  last_ = std::min(last_.value_or(now.vehicle), now.vehicle);  // which may have jumped back
  if (window_.start < 0.0) window_.start = now.steady;
  summarize(status, now);
  add_counts(status);
  add_times(status, now);
  tally_.begin_window();
  window_ = Window{};
  window_.start = now.steady;
}

}  // namespace falko_slam
