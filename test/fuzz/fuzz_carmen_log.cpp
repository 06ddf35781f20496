// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/carmen_log.hpp"
#include "falko_slam/sensor/log_kind.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_carmen_log(const std::string& input) {
  const std::string path = input_file("carmen.log", input);
  read_or_refuse(path, [&] { recognize_log(path); });
  read_or_refuse(path, [&] {
    CarmenLogReader reader(path);
    LaserScan scan;
    while (const auto record = reader.next()) {
      if (const auto* read = std::get_if<CarmenScan>(&*record)) normalize(read->raw(), {}, scan);
    }
    describe(reader.report());
  });
}
