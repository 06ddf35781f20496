// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {

/// More cells than any map has: 1.2 km by 1.2 km at 5 cm need twice as many.
constexpr std::size_t kMaxGridCells = std::size_t{1} << 28U;
constexpr std::int8_t kUnknownCell = -1;

/// A rectangle of equal cells, as in nav_msgs/OccupancyGrid.
///
/// Cell (0, 0) is the lower left one, its lower left corner the origin of the grid; columns run
/// along the grid's x axis, rows along y. `cells` is row-major from the lowest row: -1 unknown,
/// else the probability of being occupied in percent, 0..100.
struct GridMap {
  std::size_t width = 0;
  std::size_t height = 0;
  double resolution = 0.05;  ///< side of a cell [m]
  Pose2 map_T_origin;
  std::vector<std::int8_t> cells;

  std::int8_t at(std::size_t column, std::size_t row) const { return cells[row * width + column]; }
};

/// Throws std::invalid_argument unless the number of cells is width times height and not above
/// kMaxGridCells, all of them are in [-1, 100], and resolution and origin are finite.
void validate(const GridMap& map);

/// Where the probability of a cell becomes a statement. The defaults are those of map_saver.
struct MapThresholds {
  double occupied = 0.65;  ///< at least this: occupied [0, 1]
  double free = 0.25;      ///< at most this, and not occupied: free [0, 1]
};
void validate(const MapThresholds& thresholds);

/// 0 for a free cell, 100 for an occupied one, -1 for all others: what planners expect of a map
/// topic. (costmap_2d with its defaults takes a cell below 100 for free.)
std::int8_t trinary_cell(std::int8_t cell, const MapThresholds& thresholds);
GridMap trinary(const GridMap& map, const MapThresholds& thresholds = {});

}  // namespace falko_slam
