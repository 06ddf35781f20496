// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>

namespace falko_slam {

using diagnostic_msgs::DiagnosticStatus;

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
  status.summaryf(DiagnosticStatus::OK, "%zu keyframes, %zu loops", keyframes_, accepted_);
  tally_.summarize(status, now);

  const auto keyframes = static_cast<double>(window_.keyframes);
  tally_.add_counts(status);
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
  tally_.add_last(status);
  tally_.begin_window();
  window_ = Window{};
}

}  // namespace falko_slam
