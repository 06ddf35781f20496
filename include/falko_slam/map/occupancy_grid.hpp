// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/map/grid_map.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct ScanFootprint;

struct OccupancyGridParams {
  double resolution = 0.05;       ///< side of a cell [m], [0.01, 1]
  double hit_probability = 0.8;   ///< of a cell in which a beam ends, [0.5, 0.99]
  double miss_probability = 0.4;  ///< of a cell that a beam has passed, [0.01, 0.5]
  double min_probability = 0.05;  ///< a cell never gets surer to be free, [0.001, 0.5]
  double max_probability = 0.97;  ///< a cell never gets surer to be occupied, [0.5, 0.999]
  /// Beams that end farther away put no obstacle into the map [m], [resolution, 4000 cells]. At 30
  /// m an error of 0.1 deg in the heading is a cell.
  double max_range = 30.0;
  double max_free_range = 30.0;  ///< no beam frees cells farther away [m], [max_range, 4000 cells]
  /// How far a beam without return, or above the scan's range_max, frees cells [m], [0,
  /// max_free_range]. 0: it says nothing, since black or shiny surfaces do not return either.
  double no_return_free_range = 0.0;
};
/// Throws std::invalid_argument that names the field.
void validate(const OccupancyGridParams& params);

/// How occupied the cells of the plane are, as log-odds, from scans with known poses
/// (\cite moravec1985, \cite thrun2005probabilistic, Table 9.1).
///
/// A scan changes a cell once: by the log-odds of `hit_probability` if any beam ends in it, else by
/// those of `miss_probability` if any beam has passed it. So a wall seen at a grazing angle is
/// not eroded by the beams that pass close to the points where others end.
///
/// The grid is aligned with the axes of the map frame and grows by tiles of 64 x 64 cells, 8 kB
/// each, where beams come: memory is bounded by the area seen. The same scans and poses in the same
/// order give the same grid, bit by bit. Not safe to use from several threads at once.
class OccupancyGrid {
 public:
  explicit OccupancyGrid(const OccupancyGridParams& params = {});

  /// Throws std::invalid_argument if the pose is not finite or farther than 1000 km from the
  /// origin.
  void add(const LaserScan& scan, const Pose2& map_T_laser);

  /// The smallest rectangle around all cells that are not unknown; 0 x 0 if there are none. Throws
  /// std::runtime_error if that needs more than kMaxGridCells.
  GridMap rasterise() const;

  std::size_t tiles() const { return tiles_.size(); }
  const OccupancyGridParams& params() const { return params_; }

  static constexpr std::int32_t kTileSide = 64;  ///< cells

 private:
  using Cell = std::int16_t;  // log-odds in units of 1 / 1024, or the least number: never seen
  using Tile = std::array<Cell, static_cast<std::size_t>(kTileSide) * kTileSide>;
  using TileIndex = std::pair<std::int32_t, std::int32_t>;  // row, column

  Tile& tile_at(const TileIndex& index);
  void add_to_tile(const TileIndex& index, const ScanFootprint& seen);

  OccupancyGridParams params_;
  std::array<int, 4> change_{};  // log-odds by the mark of a cell in a scan's footprint
  int min_ = 0;
  int max_ = 0;
  std::map<TileIndex, Tile> tiles_;
};

/// A scan and where its laser stood; the scan is borrowed.
struct ScanAtPose {
  const LaserScan* scan = nullptr;
  Pose2 map_T_laser;
};

/// The map of all scans. A pure function: it may run in any thread.
GridMap build_occupancy_grid(const std::vector<ScanAtPose>& scans,
                             const OccupancyGridParams& params = {});

}  // namespace falko_slam
