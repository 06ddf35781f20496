// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "falko_slam/evaluation/feature_evaluation.hpp"

namespace falko_slam {
namespace cli {

/// The tables as text on standard output.
void print_report(const FeatureEvaluation& evaluation, const FeatureEvaluationParams& params);

/// All figures with the conditions they were found under; scripts/plot_features draws them.
nlohmann::json as_json(const FeatureEvaluation& evaluation, const FeatureEvaluationParams& params);

}  // namespace cli
}  // namespace falko_slam
