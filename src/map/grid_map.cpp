// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/grid_map.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

constexpr std::int8_t kFreeCell = 0;
constexpr std::int8_t kOccupiedCell = 100;

}  // namespace

void validate(const GridMap& map) {
  const std::string size = std::to_string(map.width) + " x " + std::to_string(map.height);
  if (map.height != 0 && map.width > kMaxGridCells / map.height) {
    throw std::invalid_argument("grid of " + size + " cells: too large");
  }
  if (map.cells.size() != map.width * map.height) {
    throw std::invalid_argument("grid of " + size + " cells holds " +
                                std::to_string(map.cells.size()));
  }
  require_in_range("resolution", map.resolution, 1e-6, 1e6);
  constexpr double kFinite = std::numeric_limits<double>::max();
  require_in_range("origin x", map.map_T_origin.x(), -kFinite, kFinite);
  require_in_range("origin y", map.map_T_origin.y(), -kFinite, kFinite);
  require_in_range("origin yaw", map.map_T_origin.theta(), -kFinite, kFinite);
  for (const std::int8_t cell : map.cells) {
    if (cell < kUnknownCell || cell > kOccupiedCell) require_in_range("cell", int{cell}, -1, 100);
  }
}

void validate(const MapThresholds& thresholds) {
  require_in_range("occupied_threshold", thresholds.occupied, 0.0, 1.0);
  require_in_range("free_threshold", thresholds.free, 0.0, thresholds.occupied);
}

std::int8_t trinary_cell(std::int8_t cell, const MapThresholds& thresholds) {
  if (cell < 0) return kUnknownCell;
  if (cell >= 100.0 * thresholds.occupied) return kOccupiedCell;
  return cell <= 100.0 * thresholds.free ? kFreeCell : kUnknownCell;
}

GridMap trinary(const GridMap& map, const MapThresholds& thresholds) {
  validate(thresholds);
  GridMap result = map;
  for (std::int8_t& cell : result.cells) cell = trinary_cell(cell, thresholds);
  return result;
}

}  // namespace falko_slam
