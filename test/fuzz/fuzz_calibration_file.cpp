// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_file.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_calibration_file(const std::string& input) {
  const std::string path = input_file("agv.yaml", input);
  read_or_refuse(path, [&] {
    const StoredCalibration stored = read_calibration(path);
    write_calibration(path, stored);
    read_calibration(path);
  });
}
