// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/detector_run.hpp"

#include <utility>

namespace falko_slam {

DetectorRun::DetectorRun(const std::vector<PosedScan>& scans, const LoopDetectorParams& params)
    : detector_(params) {
  std::vector<double> times;
  times.reserve(scans.size());
  for (const PosedScan& scan : scans) {
    times.push_back(milliseconds_of([&] { detector_.add(scan.scan, scan.map_T_laser); }));
  }
  creation_ = loop_timing(std::move(times));
}

LoopMethodResult DetectorRun::close_all(const LoopTruth& truth) {
  std::vector<LoopVerdict> verdicts(truth.scans(), LoopVerdict::kNotMatched);
  LoopMethod method;
  method.name = "falko_slam";
  method.creation = creation_;
  method.close = [&](std::size_t source, const LoopTruth&) -> LoopTrial {
    const LoopDetection detection = detector_.detect({source}, [&](const Keyframe& target) {
      return truth.admits(source, static_cast<std::size_t>(target.id.value));
    });
    if (detection.candidates.empty()) return {};
    const LoopCandidate& best = detection.candidates.front();
    if (best.score <= 0.0) return {};
    verdicts[source] = best.verdict;
    return {LoopClosure{static_cast<std::size_t>(best.target.value), best.score,
                        best.target_T_source->pose},
            std::nullopt};
  };
  std::vector<LoopAnswer> answers;
  LoopMethodResult result = run_method(method, truth, answers);
  for (std::size_t source = 0; source < answers.size(); ++source) {
    if (verdicts[source] != LoopVerdict::kAccepted) answers[source].closed = false;
    result.ambiguous += verdicts[source] == LoopVerdict::kAmbiguous ? 1U : 0U;
  }
  result.accepted = operating_point(answers, detector_.params().min_score);
  return result;
}

}  // namespace falko_slam
