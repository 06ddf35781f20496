// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

namespace falko_slam {
namespace test {

/// Where recordings are, if there are any.
inline std::string recording_folder() {
  const char* folder = std::getenv("FALKO_SLAM_DATA");
  return folder ? folder : FALKO_SLAM_SOURCE_DIR "/../shared/data";
}

/// Raw CARMEN logs and their relations.
inline std::string carmen_folder() { return recording_folder() + "/carmen/"; }

/// The encoders of a tricycle, its own odometry and what a tracker saw.
inline std::string tricycle_recording() { return recording_folder() + "/tricycle/dataset.txt"; }

/// Bags of scans with intensities and one reflector.
inline std::string reflector_folder() { return recording_folder() + "/reflectors/"; }

/// Robots among surveyed landmarks.
inline std::string mrclam_folder() { return recording_folder() + "/landmarks/mrclam9"; }

}  // namespace test
}  // namespace falko_slam
