// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/line_reader.hpp"

#include <initializer_list>

#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_packed_lines(const std::string& input) {
  for (const char* name : {"lines.gz", "lines.bz2"}) {
    const std::string path = input_file(name, input);
    read_or_refuse(path, [&] {
      LineReader reader(path);
      std::string line;
      while (reader.next(line)) {
      }
    });
  }
}
