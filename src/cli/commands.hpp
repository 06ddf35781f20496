// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>

namespace falko_slam {
namespace cli {

// Each adds its verb to the command line; what the verb does runs when its words are parsed.
void add_calibrate(CLI::App& app);
void add_convert(CLI::App& app);
void add_detect(CLI::App& app);
void add_evaluate(CLI::App& app);
void add_localize(CLI::App& app);
void add_map(CLI::App& app);
void add_optimize(CLI::App& app);
void add_evaluate_calibration(CLI::App& evaluate);   // below `evaluate`
void add_evaluate_localization(CLI::App& evaluate);  // the same
void add_evaluate_precision(CLI::App& evaluate);     // the same
void add_evaluate_reflectors(CLI::App& evaluate);    // the same
void add_evaluate_slam(CLI::App& evaluate);          // the same
void add_evaluate_soak(CLI::App& evaluate);          // the same
void add_parameters(CLI::App& app);
void add_simulate(CLI::App& app);
void add_slam(CLI::App& app);

/// A check of an option's value, as CLI::Range, which lets nan pass.
inline CLI::Validator number_in(double min, double max) {
  std::ostringstream range;
  range << "in [" << min << ", " << max << "]";
  const auto check = [min, max, wanted = range.str()](const std::string& text) {
    std::istringstream in(text);
    double value = 0.0;
    const bool good = in >> value && in.eof() && value >= min && value <= max;
    return good ? std::string() : text + ": must be a number " + wanted;
  };
  return {check, range.str()};
}

/// A check of --json where the tables already go to the console.
inline CLI::Validator a_file() {
  const auto check = [](const std::string& text) {
    return text == "-" ? std::string("must be a file: the tables go to the console") : "";
  };
  return {check, "FILE"};
}

}  // namespace cli
}  // namespace falko_slam
