// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/mrclam_log.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_mrclam_log(const std::string& input) {
  const auto parts = parts_of<5>(input);
  input_file("Barcodes.dat", parts[0]);
  input_file("Landmark_Groundtruth.dat", parts[1]);
  input_file("Robot1_Odometry.dat", parts[2]);
  input_file("Robot1_Measurement.dat", parts[3]);
  const std::string last = input_file("Robot1_Groundtruth.dat", parts[4]);
  const std::string folder = last.substr(0, last.find_last_of('/'));
  read_or_refuse(folder, [&] { read_mrclam(folder, 1); });
}
