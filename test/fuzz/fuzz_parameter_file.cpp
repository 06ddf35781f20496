// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/yaml_parameters.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_parameter_file(const std::string& input) {
  const std::string path = input_file("parameters.yaml", input);
  read_or_refuse(path, [&] { read_parameter_file(path); });
}
