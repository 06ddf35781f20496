// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose_estimate.hpp"
#include "falko_slam/geometry/trajectory.hpp"

namespace falko_slam {

/// What a robot of \cite leung2011 was told to do from this instant on.
struct MrclamOdometry {
  Time stamp{};
  double speed = 0.0;      ///< [m/s]
  double turn_rate = 0.0;  ///< [rad/s]
};

/// A landmark as its camera saw it.
struct MrclamMeasurement {
  Time stamp{};
  std::uint32_t landmark = 0;  ///< subject number
  double range = 0.0;          ///< [m], above zero
  double bearing = 0.0;        ///< [rad]
};

struct MrclamLandmark {
  std::uint32_t number = 0;  ///< subject number
  PointEstimate position;    ///< as surveyed
};

/// All that is known of one robot's run. Each list in the order of its file.
struct MrclamRun {
  std::vector<MrclamOdometry> odometry;
  std::vector<MrclamMeasurement> measurements;  ///< of landmarks only
  Trajectory truth;
  std::vector<MrclamLandmark> landmarks;
  std::size_t other_measurements = 0;  ///< left out: of robots and of barcodes that nobody has
};

/// Reads Barcodes, Landmark_Groundtruth, Robot<n>_Odometry, Robot<n>_Measurement and
/// Robot<n>_Groundtruth of a folder, each as .dat or .dat.gz. Throws std::runtime_error that names
/// the file, and the line of what is no number or not as many as there should be.
MrclamRun read_mrclam(const std::string& folder, int robot);

}  // namespace falko_slam
