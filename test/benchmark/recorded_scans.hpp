// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "falko_slam/evaluation/posed_scan.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "support/scene.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace benchmarks {

constexpr int kBeams = 360;  ///< of the recording; simulated scans have as many

inline std::vector<PosedScan> simulated_scans() {
  std::mt19937_64 random(1);
  SimulatedLaserParams laser;
  laser.beams = kBeams;
  laser.angle_min = -0.5 * kPi;
  laser.angle_increment = kPi / static_cast<double>(kBeams);
  std::vector<PosedScan> scans;
  for (const Pose2& pose : office_path(0.1)) {
    const std::vector<float> ranges = simulate_ranges(office_scene(), pose, laser, random);
    RawScan raw;
    raw.angle_min = laser.angle_min;
    raw.angle_increment = laser.angle_increment;
    raw.angle_max = laser.angle_min + (kBeams - 1) * laser.angle_increment;
    raw.range_max = laser.range_max;
    raw.ranges = ranges.data();
    raw.range_count = ranges.size();
    scans.emplace_back().map_T_laser = pose;
    normalize(raw, {}, scans.back().scan);
  }
  return scans;
}

/// Those of $FALKO_SLAM_DATA/benchmark/fr079.log.gz, or of a simulated office where it is absent.
inline std::vector<PosedScan> recorded_scans() {
  const char* folder = std::getenv("FALKO_SLAM_DATA");
  const std::string log = std::string(folder == nullptr ? "." : folder) + "/benchmark/fr079.log.gz";
  if (!std::ifstream(log)) {
    std::cerr << "no $FALKO_SLAM_DATA/benchmark/fr079.log.gz: simulated scans instead\n";
    return simulated_scans();
  }
  CarmenReport report;
  std::vector<PosedScan> scans = load_posed_scans(log, report);
  std::cerr << log << ": " << describe(report) << "\n";
  return scans;
}

}  // namespace benchmarks
}  // namespace falko_slam
