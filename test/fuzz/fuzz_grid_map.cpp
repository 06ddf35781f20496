// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/map_file.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_grid_map(const std::string& input) {
  const auto parts = parts_of<2>(input);
  const std::string yaml = input_file("map.yaml", parts[0]);
  const std::string image = input_file("map.pgm", parts[1]);
  const std::string folder = image.substr(0, image.find_last_of('/'));
  read_or_refuse(folder, [&] { validate(read_map(yaml)); });
}
