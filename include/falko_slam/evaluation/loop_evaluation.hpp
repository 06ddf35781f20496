// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/kidnapped_study.hpp"
#include "falko_slam/evaluation/thesis_methods.hpp"

namespace falko_slam {

/// Those of thesis_method_names(), and "falko_slam": our loop detector.
std::vector<std::string> loop_method_names();

struct LoopEvaluationParams {
  std::vector<LoopProtocol> protocols = {LoopProtocol::kOffline, LoopProtocol::kOnline,
                                         LoopProtocol::kRevisits};
  std::vector<std::string> methods = loop_method_names();
  LoopProtocolParams protocol;
  ThesisMethodParams thesis;
  LoopDetectorParams detector;
};

/// Throws std::invalid_argument, with the names that are known, if a method is not, or none is
/// asked for.
void validate(const LoopEvaluationParams& params);

struct LoopEvaluation {
  std::vector<LoopMethodResult> methods;     ///< by protocol, then by method
  std::optional<KidnappedResult> kidnapped;  ///< of our detector
};

/// Fig. 4.2 and Table 4.1 of \cite kallasi2017 for one log, and how well our detector places a
/// robot that does not know where it is. `tell` hears what is worked on.
/// Throws std::invalid_argument as validate().
LoopEvaluation evaluate_loops(const std::vector<PosedScan>& scans,
                              const LoopEvaluationParams& params,
                              const std::function<void(const std::string&)>& tell);

}  // namespace falko_slam
