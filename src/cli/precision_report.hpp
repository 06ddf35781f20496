// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "falko_slam/evaluation/precision_evaluation.hpp"

namespace falko_slam {
namespace cli {

/// Tables as 5.3, 5.4 and 5.5 of the thesis.
void print_precision(const std::vector<PrecisionRun>& runs);

nlohmann::json as_json(const std::vector<PrecisionRun>& runs);

}  // namespace cli
}  // namespace falko_slam
