// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/imk_file.hpp"
#include "falko_slam/localization/landmark_map.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_imk_file(const std::string& input) {
  const std::string path = input_file("layout.imk", input);
  read_or_refuse(path, [&] { validate(read_imk(path)); });
}
