// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/loop_evaluation.hpp"

#include <algorithm>
#include <stdexcept>

namespace falko_slam {
namespace {

constexpr char kOurs[] = "falko_slam";

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<std::string> loop_method_names() {
  std::vector<std::string> names = thesis_method_names();
  names.emplace_back(kOurs);
  return names;
}

void validate(const LoopEvaluationParams& params) {
  const std::vector<std::string> known = loop_method_names();
  std::string list;
  for (const std::string& name : known) list.append(list.empty() ? "" : ", ").append(name);
  if (params.methods.empty()) throw std::invalid_argument("methods: none of " + list);
  const auto unknown = std::find_if(params.methods.begin(), params.methods.end(),
                                    [&](const std::string& name) { return !holds(known, name); });
  if (unknown != params.methods.end()) {
    throw std::invalid_argument("methods: \"" + *unknown + "\" is not one of " + list);
  }
  validate(params.thesis);
  validate(params.detector);
}

LoopEvaluation evaluate_loops(const std::vector<PosedScan>& scans,
                              const LoopEvaluationParams& params,
                              const std::function<void(const std::string&)>& tell) {
  validate(params);
  std::vector<LoopMethod> others;
  std::optional<DetectorRun> ours;
  for (const std::string& name : loop_method_names()) {
    if (!holds(params.methods, name)) continue;
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
