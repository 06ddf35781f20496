// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/map/map_file.hpp"

namespace falko_slam {

/// The YAML file of a map, as map_server reads it.
struct MapDescription {
  std::string image;
  double resolution = 0.0;
  Pose2 origin;
  bool negate = false;
  double occupied = 0.0;  ///< occupied_thresh
  double free = 0.0;      ///< free_thresh
  MapMode mode = MapMode::kTrinary;
};

/// Throws std::runtime_error that says what is wrong, and in which line where that is known.
MapDescription parse_map_description(const std::string& text);

}  // namespace falko_slam
