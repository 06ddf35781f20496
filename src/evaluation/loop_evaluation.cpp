// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_evaluation.hpp"

#include <algorithm>
#include <stdexcept>

namespace falko_slam {
namespace {

constexpr char kOurs[] = "falko_slam";

void require_known(const std::vector<std::string>& names) {
  const std::vector<std::string> known = loop_method_names();
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string list;
    for (const std::string& other : known) list += (list.empty() ? "" : ", ") + other;
    throw std::invalid_argument("methods: \"" + name + "\" is not one of " + list);
  }
}

}  // namespace

std::vector<std::string> loop_method_names() {
  std::vector<std::string> names = thesis_method_names();
  names.emplace_back(kOurs);
  return names;
}

LoopEvaluation evaluate_loops(const std::vector<PosedScan>& scans,
                              const LoopEvaluationParams& params,
                              const std::function<void(const std::string&)>& tell) {
  require_known(params.methods);
  std::vector<LoopMethod> others;
  std::optional<DetectorRun> ours;
  for (const std::string& name : loop_method_names()) {
    if (std::find(params.methods.begin(), params.methods.end(), name) == params.methods.end()) {
      continue;
    }
    tell(name + " signatures");
    if (name == kOurs) {
      ours.emplace(scans, params.detector);
    } else {
      others.push_back(thesis_method(name, scans, params.thesis));
    }
  }

  LoopEvaluation evaluation;
  for (const LoopProtocol protocol : params.protocols) {
    const LoopTruth truth(scans, protocol, params.protocol);
    for (const LoopMethod& method : others) {
      tell(method.name + " " + name_of(protocol));
      std::vector<LoopAnswer> answers;
      evaluation.methods.push_back(run_method(method, truth, answers));
    }
    if (!ours) continue;
    tell(std::string(kOurs) + " " + name_of(protocol));
    evaluation.methods.push_back(ours->close_all(truth));
  }
  if (ours) {
    tell(std::string(kOurs) + " kidnapped");
    evaluation.kidnapped = study_kidnapped(scans, *ours, {params.protocol});
  }
  return evaluation;
}

}  // namespace falko_slam
