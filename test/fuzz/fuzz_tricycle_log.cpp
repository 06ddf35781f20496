// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle_log.hpp"

#include <stdexcept>

#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_tricycle_log(const std::string& input) {
  const std::string path = input_file("tricycle.txt", input);
  read_or_refuse(path, [&] {
    TricycleLogReader reader(path);
    while (reader.next()) {
    }
    describe(reader.report());
    try {
      tricycle_params_of(reader.header());
      validate(encoder_params_of(reader.header()));
    } catch (const std::invalid_argument&) {  // describes no vehicle
    }
  });
}
