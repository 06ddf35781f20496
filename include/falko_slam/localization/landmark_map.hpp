// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "falko_slam/localization/landmark.hpp"

namespace falko_slam {

/// What layouts of SICK's scanners tell of a reflector beside its place; kept for them only.
struct ReflectorLayout {
  double diameter = 0.08;         ///< or width [m]
  int type = 1;                   ///< as the device has it, 0 to 255
  int subtype = 2;                ///< the same, 0 to 65535
  std::vector<int> layers = {0};  ///< the same; at least one
};

/// A landmark with all that a map keeps of it; a filter needs Landmark only.
struct MapLandmark {
  int id = 0;  ///< not negative; no two in a map have the same
  LandmarkKind kind = LandmarkKind::kReflector;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    ///< in the map [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of the position [m^2]
  int hits = 0;                                          ///< scans that it was seen in
  std::string name;                                      ///< for people; may be empty
  ReflectorLayout layout;                                ///< of a reflector
};

struct LandmarkMap {
  std::vector<MapLandmark> landmarks;

  /// Null if there is none.
  const MapLandmark* find(int id) const;
};

/// Throws std::invalid_argument, "landmarks[2].hits = -1: must be in [0, 1000000000]", for what no
/// map can be: ids that repeat, numbers out of range, what is no covariance.
void validate(const LandmarkMap& map);

/// As YAML, whole or not at all. Throws std::invalid_argument if it would not be read back,
/// std::runtime_error that names the file if it cannot be written; then the old one is still there.
void write_landmark_map(const std::string& path, const LandmarkMap& map);

/// Throws std::runtime_error that names file, line and key: what is missing, unknown, out of its
/// range, no covariance, there twice, or cut off.
LandmarkMap read_landmark_map(const std::string& path);

}  // namespace falko_slam
