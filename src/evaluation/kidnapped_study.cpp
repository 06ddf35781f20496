// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/kidnapped_study.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace falko_slam {

KidnappedResult study_kidnapped(const std::vector<PosedScan>& scans, DetectorRun& run,
                                const KidnappedParams& params) {
  LoopDetector& detector = run.detector();
  if (detector.keyframes().size() != scans.size()) {
    throw std::invalid_argument("scans: " + std::to_string(scans.size()) + ", but the run has " +
                                std::to_string(detector.keyframes().size()));
  }
  if (params.hypotheses == 0) throw std::invalid_argument("hypotheses = 0: must be at least 1");

  const LoopTruth truth(scans, LoopProtocol::kKidnapped, params.protocol);
  KidnappedResult result;
  result.scans = scans.size();
  result.visited = truth.loops();
  std::vector<LoopAnswer> answers(scans.size());
  std::vector<double> times;
  std::size_t best_right = 0;
  std::size_t any_right = 0;
  for (std::size_t source = 0; source < scans.size(); ++source) {
    std::vector<LoopCandidate> found;
    times.push_back(milliseconds_of([&] {
      found = detector.locate(scans[source].scan, params.hypotheses, [&](const Keyframe& target) {
        return truth.admits(source, static_cast<std::size_t>(target.id.value));
      });
    }));
    const auto right = [&](const LoopCandidate& candidate) {
      return truth.is_right(source, static_cast<std::size_t>(candidate.target.value),
                            candidate.target_T_source->pose);
    };
    LoopAnswer& answer = answers[source];
    answer.has_loop = truth.has_loop(source);
    if (found.empty()) continue;
    answer.closed = true;
    answer.score = found.front().score;
    answer.right = right(found.front());
    if (!answer.has_loop) continue;
    best_right += answer.right ? 1U : 0U;
    any_right += std::any_of(found.begin(), found.end(), right) ? 1U : 0U;
  }
  if (result.visited > 0) {
    result.best_right = static_cast<double>(best_right) / static_cast<double>(result.visited);
    result.any_right = static_cast<double>(any_right) / static_cast<double>(result.visited);
  }
  result.best = summarize(loop_curve(answers));
  result.locating = loop_timing(std::move(times));
  result.travelled = run.close_all(truth);
  return result;
}

}  // namespace falko_slam
