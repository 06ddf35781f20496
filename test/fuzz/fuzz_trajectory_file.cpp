// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/trajectory_file.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_trajectory_file(const std::string& input) {
  const std::string path = input_file("path.tum", input);
  read_or_refuse(path, [&] {
    const std::string text = tum_text(read_tum(path));
    input_file("path.tum", text);
    require(tum_text(read_tum(path)) == text, "what was written is read as the same text");
  });
}
