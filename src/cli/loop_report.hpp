// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "falko_slam/evaluation/loop_evaluation.hpp"

namespace falko_slam {
namespace cli {

/// The tables as text on standard output.
void print_report(const LoopEvaluation& evaluation);

/// All figures: "methods", which scripts/plot_loops draws, and "kidnapped".
nlohmann::json as_json(const LoopEvaluation& evaluation);

}  // namespace cli
}  // namespace falko_slam
