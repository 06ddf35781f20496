// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_method.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace falko_slam {

LoopTiming loop_timing(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return {};
  std::sort(milliseconds.begin(), milliseconds.end());
  const double sum = std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0);
  return {sum / static_cast<double>(milliseconds.size()), milliseconds[milliseconds.size() / 2],
          milliseconds[milliseconds.size() * 99 / 100]};
}

LoopMethodResult run_method(const LoopMethod& method, const LoopTruth& truth,
                            std::vector<LoopAnswer>& answers) {
  LoopMethodResult result;
  result.method = method.name;
  result.protocol = truth.protocol();
  result.scans = truth.scans();
  result.loops = truth.loops();
  result.detection = method.detection;
  result.creation = method.creation;
  answers.assign(truth.scans(), {});
  std::vector<double> closing;
  std::vector<double> search;
  std::vector<double> association;
  for (std::size_t source = 0; source < truth.scans(); ++source) {
    LoopTrial trial;
    closing.push_back(milliseconds_of([&] { trial = method.close(source, truth); }));
    if (trial.search) {
      search.push_back(*trial.search);
      association.push_back(closing.back() - *trial.search);
    }
    answers[source].has_loop = truth.has_loop(source);
    if (!trial.closure) continue;
    const LoopClosure& closure = *trial.closure;
    answers[source].closed = true;
    answers[source].score = closure.score;
    answers[source].right = truth.is_right(source, closure.target, closure.target_T_source);
  }
  result.closing = loop_timing(std::move(closing));
  if (!search.empty()) {
    result.search = loop_timing(std::move(search));
    result.association = loop_timing(std::move(association));
  }
  result.curve = loop_curve(answers);
  result.summary = summarize(result.curve);
  return result;
}

}  // namespace falko_slam
