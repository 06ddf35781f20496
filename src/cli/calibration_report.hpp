// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "falko_slam/evaluation/calibration_study.hpp"

namespace falko_slam {
namespace cli {

/// The tables as text on standard output; those of the thesis that belong to the model beside ours.
void print_report(const CalibrationStudy& study);

/// All figures in SI units, ours and those of the thesis; scripts/plot_calibration draws them.
nlohmann::json as_json(const CalibrationStudy& study);

}  // namespace cli
}  // namespace falko_slam
