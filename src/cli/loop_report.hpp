// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "falko_slam/evaluation/drive_evaluation.hpp"
#include "falko_slam/evaluation/loop_evaluation.hpp"

namespace falko_slam {
namespace cli {

/// The tables as text on standard output.
void print_report(const LoopEvaluation& evaluation);

/// All figures: "methods", which scripts/plot_loops draws, and "kidnapped".
nlohmann::json as_json(const LoopEvaluation& evaluation);

void print_report(const std::vector<DriveResult>& results);
nlohmann::json as_json(const std::vector<DriveResult>& results);

}  // namespace cli
}  // namespace falko_slam
