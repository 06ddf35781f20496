// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/scenario_file.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_scenario(const std::string& input) {
  const std::string path = input_file("scenario.yaml", input);
  read_or_refuse(path, [&] { read_scenario(path); });
}
