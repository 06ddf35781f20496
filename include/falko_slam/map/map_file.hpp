// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "falko_slam/map/grid_map.hpp"

namespace falko_slam {

/// What the gray values of the image mean: map_server's `mode`.
enum class MapMode {
  kTrinary,  ///< free, occupied or unknown
  kScale,    ///< the probabilities between the two thresholds
  kRaw,      ///< the cells' values themselves
};

struct MapFileParams {
  MapMode mode = MapMode::kTrinary;  ///< kRaw keeps all probabilities; kScale cannot be written
  MapThresholds thresholds;          ///< of kTrinary
};

/// Writes a map as map_server's map_saver does: a YAML file with resolution and origin, and the
/// image it names, a binary PGM of the same name beside it. Each of the two is written whole or not
/// at all, the image first.
///
/// Throws std::invalid_argument for an invalid map, a name that does not end in ".yaml" or kScale,
/// and std::runtime_error that names the file if it cannot be written.
void write_map(const std::string& yaml_path, const GridMap& map, const MapFileParams& params = {});

/// Reads what map_server reads, with 8-bit binary PGM images only. Throws std::runtime_error that
/// names the file and what is wrong with it.
GridMap read_map(const std::string& yaml_path);

}  // namespace falko_slam
