// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace falko_slam {
namespace cli {

// Each adds its verb to the command line; what the verb does runs when its words are parsed.
void add_convert(CLI::App& app);
void add_detect(CLI::App& app);
void add_evaluate(CLI::App& app);
void add_parameters(CLI::App& app);
void add_simulate(CLI::App& app);

}  // namespace cli
}  // namespace falko_slam
