// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/relations.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_relations(const std::string& input) {
  const std::string path = input_file("relations.txt", input);
  read_or_refuse(path, [&] { read_relations(path); });
}
