// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "falko_slam/geometry/trajectory.hpp"
#include "falko_slam/ros_bridge/simulation_messages.hpp"

namespace falko_slam {

struct SimulationBagParams {
  SimulationFrames frames;
  Time start = kSimulationStart;  ///< stamp of the first scan
  std::uint64_t seed = 1;
  double duration = 0.0;    ///< [s]; 0: until the drive is over
  std::string drive_bag;    ///< who leads the vehicle, read_drive(); empty: the scenario does
  std::string drive_topic;  ///< in that bag; empty: the only one that there is
  bool replace = false;     ///< an existing bag
};

struct SimulationBagReport {
  std::size_t scans = 0;
  double seconds = 0.0;  ///< of the vehicle's time
  std::string drive;     ///< one line: who led it
  Trajectory truth;      ///< base_link in the world, when the first beam of each scan left
};

/// Simulates as fast as it can and writes what the vehicle publishes to a bag: `scan`,
/// `reflectors`, `encoders`, `joint_states`, `odom`, `tf`, `ground_truth`, and latched `tf_static`,
/// `world_markers` and, in the end, `ground_truth_path`. The same scenario, seed and drive give the
/// same bytes.
///
/// Each message has the time at which a vehicle could have sent it: scans that of their last beam.
/// `progress` is called after each scan. Throws std::runtime_error that names the file.
SimulationBagReport simulate_to_bag(Scenario scenario, const SimulationBagParams& params,
                                    const std::string& bag, const std::function<void()>& progress);

}  // namespace falko_slam
