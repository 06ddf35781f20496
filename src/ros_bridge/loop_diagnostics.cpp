// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <utility>

namespace falko_slam {

using diagnostic_msgs::DiagnosticStatus;

LoopDiagnostics::LoopDiagnostics(std::string topic, double timeout)
    : topic_(std::move(topic)), timeout_(timeout) {}

void LoopDiagnostics::received(const ScanReport& report, double now) {
  last_ = report;
  last_scan_ = now;
  ++scans_;
  if (!report.usable()) ++unusable_;
}

void LoopDiagnostics::dropped(const std::string& missing) {
  ++dropped_;
  ++window_.dropped;
  missing_ = missing;
}

void LoopDiagnostics::added(KeyframeId keyframe, const LoopDetection& detection, double duration) {
  ++keyframes_;
  ++window_.keyframes;
  window_.busy += duration;
  window_.longest = std::max(window_.longest, duration);
  for (const LoopCandidate& candidate : detection.candidates) ++verdicts_[candidate.verdict];
  if (const LoopCandidate* loop = detection.accepted()) {
    ++accepted_;
    last_accepted_ = std::to_string(keyframe.value) + " with " + std::to_string(loop->target.value);
  }
}

void LoopDiagnostics::loaded(std::size_t keyframes) {
  loaded_ = keyframes_ = keyframes;
  accepted_ = 0;
  last_accepted_ = "none yet";
  verdicts_.clear();
}

void LoopDiagnostics::report(diagnostic_updater::DiagnosticStatusWrapper& status, double now) {
  if (started_ < 0.0) started_ = now;
  const double silence = now - (last_scan_ < 0.0 ? started_ : last_scan_);

  status.summaryf(DiagnosticStatus::OK, "%zu keyframes, %zu loops", keyframes_, accepted_);
  if (scans_ > 0 && last_.usable() && last_.count(BeamStatus::kValid) == 0) {
    status.summary(DiagnosticStatus::WARN, "no valid beam: " + describe(last_));
  }
  if (window_.dropped > 0) {
    status.summaryf(DiagnosticStatus::WARN, "%zu scans dropped: %s", window_.dropped,
                    missing_.c_str());
  }
  if (scans_ > 0 && !last_.usable()) {
    status.summary(DiagnosticStatus::ERROR, "unusable scan: " + describe(last_));
  }
  if (silence > timeout_) {
    status.summaryf(DiagnosticStatus::WARN, "no scan on %s for %.1f s", topic_.c_str(), silence);
  }

  const auto keyframes = static_cast<double>(window_.keyframes);
  status.add("topic", topic_);
  status.add("scans", scans_);
  status.add("scans unusable", unusable_);
  status.add("scans dropped for want of a transform", dropped_);
  status.add("keyframes", keyframes_);
  status.add("keyframes loaded", loaded_);
  status.add("loops accepted", accepted_);
  status.add("last loop accepted", last_accepted_);
  for (const auto& [verdict, count] : verdicts_) {
    if (verdict != LoopVerdict::kAccepted) {
      status.add(std::string("candidates refused: ") + name_of(verdict), count);
    }
  }
  status.addf("time per keyframe, mean [ms]", "%.3f",
              window_.keyframes > 0 ? 1e3 * window_.busy / keyframes : 0.0);
  status.addf("time per keyframe, longest [ms]", "%.3f", 1e3 * window_.longest);
  status.add("last scan", scans_ > 0 ? describe(last_) : std::string("none yet"));
  window_ = Window{};
}

}  // namespace falko_slam
