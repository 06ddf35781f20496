// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/map/occupancy_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "falko_slam/common/validation.hpp"
#include "scan_footprint.hpp"

namespace falko_slam {
namespace {

constexpr double kUnit = 1024.0;  // of log-odds
constexpr std::int16_t kNeverSeen = std::numeric_limits<std::int16_t>::min();
constexpr double kMaxRangeInCells = 4000.0;
constexpr double kMaxCoordinate = 1e6;  // [m]

int log_odds(double probability) {
  return static_cast<int>(std::lround(kUnit * std::log(probability / (1.0 - probability))));
}

std::int8_t percent_of(int log_odds_in_units) {
  return static_cast<std::int8_t>(
      std::lround(100.0 / (1.0 + std::exp(-log_odds_in_units / kUnit))));
}

// The borders of what is in use, in cells of the plane.
struct Bounds {
  std::int32_t first_row = std::numeric_limits<std::int32_t>::max();
  std::int32_t last_row = std::numeric_limits<std::int32_t>::min();
  std::int32_t first_column = std::numeric_limits<std::int32_t>::max();
  std::int32_t last_column = std::numeric_limits<std::int32_t>::min();

  bool empty() const { return last_row < first_row; }
  void include(std::int32_t row, std::int32_t column) {
    first_row = std::min(first_row, row);
    last_row = std::max(last_row, row);
    first_column = std::min(first_column, column);
    last_column = std::max(last_column, column);
  }
};

// Rounds down, also below zero.
std::int32_t tile_of(std::int32_t cell) {
  constexpr std::int32_t kSide = OccupancyGrid::kTileSide;
  return cell >= 0 ? cell / kSide : -((kSide - 1 - cell) / kSide);
}

// Calls visit(row, column, log-odds) for each cell that is not unknown.
template <class Tiles, class Visit>
void for_each_seen(const Tiles& tiles, Visit visit) {
  constexpr std::int32_t kSide = OccupancyGrid::kTileSide;
  for (const auto& [index, tile] : tiles) {
    for (std::int32_t i = 0; i < kSide * kSide; ++i) {
      const int value = tile[static_cast<std::size_t>(i)];
      if (value == kNeverSeen) continue;
      visit(index.first * kSide + i / kSide, index.second * kSide + i % kSide, value);
    }
  }
}

}  // namespace

void validate(const OccupancyGridParams& params) {
  require_in_range("resolution", params.resolution, 0.01, 1.0);
  require_in_range("hit_probability", params.hit_probability, 0.5, 0.99);
  require_in_range("miss_probability", params.miss_probability, 0.01, 0.5);
  require_in_range("min_probability", params.min_probability, 0.001, 0.5);
  require_in_range("max_probability", params.max_probability, 0.5, 0.999);
  const double farthest = kMaxRangeInCells * params.resolution;
  require_in_range("max_range", params.max_range, params.resolution, farthest);
  require_in_range("max_free_range", params.max_free_range, params.max_range, farthest);
  require_in_range("no_return_free_range", params.no_return_free_range, 0.0, params.max_free_range);
}

OccupancyGrid::OccupancyGrid(const OccupancyGridParams& params) : params_(params) {
  validate(params);
  const int hit = log_odds(params.hit_probability);
  change_ = {0, log_odds(params.miss_probability), hit, hit};
  min_ = log_odds(params.min_probability);
  max_ = log_odds(params.max_probability);
}

OccupancyGrid::Tile& OccupancyGrid::tile_at(const TileIndex& index) {
  const auto [found, added] = tiles_.try_emplace(index);
  if (added) found->second.fill(kNeverSeen);
  return found->second;
}

void OccupancyGrid::add(const LaserScan& scan, const Pose2& map_T_laser) {
  require_in_range("x of a scan", map_T_laser.x(), -kMaxCoordinate, kMaxCoordinate);
  require_in_range("y of a scan", map_T_laser.y(), -kMaxCoordinate, kMaxCoordinate);
  require_in_range("heading of a scan", map_T_laser.theta(), -4.0, 4.0);
  const ScanFootprint seen = trace_scan(scan, map_T_laser, params_);
  if (seen.marks.empty()) return;
  const std::int32_t last_row = tile_of(seen.row + seen.height - 1);
  const std::int32_t last_column = tile_of(seen.column + seen.width - 1);
  for (std::int32_t row = tile_of(seen.row); row <= last_row; ++row) {
    for (std::int32_t column = tile_of(seen.column); column <= last_column; ++column) {
      add_to_tile({row, column}, seen);
    }
  }
}

void OccupancyGrid::add_to_tile(const TileIndex& index, const ScanFootprint& seen) {
  // In rows and columns of the tile.
  const std::int32_t row_offset = index.first * kTileSide - seen.row;
  const std::int32_t column_offset = index.second * kTileSide - seen.column;
  const std::int32_t end_row = std::min(kTileSide, seen.height - row_offset);
  const std::int32_t first_column = std::max(0, -column_offset);
  const std::int32_t end_column = std::min(kTileSide, seen.width - column_offset);
  Tile* tile = nullptr;
  for (std::int32_t row = std::max(0, -row_offset); row < end_row; ++row) {
    const std::uint8_t* marks =
        seen.marks.data() + std::ptrdiff_t{row + row_offset} * seen.width + column_offset;
    for (std::int32_t column = first_column; column < end_column; ++column) {
      if (marks[column] == 0) continue;
      if (tile == nullptr) tile = &tile_at(index);
      Cell& cell = (*tile)[static_cast<std::size_t>(std::ptrdiff_t{row} * kTileSide + column)];
      const int before = cell == kNeverSeen ? 0 : cell;
      cell = static_cast<Cell>(std::clamp(before + change_[marks[column]], min_, max_));
    }
  }
}

GridMap OccupancyGrid::rasterise() const {
  Bounds bounds;
  for_each_seen(tiles_,
                [&](std::int32_t row, std::int32_t column, int) { bounds.include(row, column); });
  GridMap map;
  map.resolution = params_.resolution;
  if (bounds.empty()) return map;
  map.width = static_cast<std::size_t>(std::int64_t{bounds.last_column} - bounds.first_column + 1);
  map.height = static_cast<std::size_t>(std::int64_t{bounds.last_row} - bounds.first_row + 1);
  if (map.width > kMaxGridCells / map.height) {
    throw std::runtime_error("occupancy grid: " + std::to_string(map.width) + " x " +
                             std::to_string(map.height) + " cells are too many for one map");
  }
  map.map_T_origin = {bounds.first_column * map.resolution, bounds.first_row * map.resolution, 0.0};
  map.cells.assign(map.width * map.height, kUnknownCell);
  std::vector<std::int8_t> percent;
  for (int value = min_; value <= max_; ++value) percent.push_back(percent_of(value));
  for_each_seen(tiles_, [&](std::int32_t row, std::int32_t column, int value) {
    const auto at_row = static_cast<std::size_t>(row - bounds.first_row);
    const auto at_column = static_cast<std::size_t>(column - bounds.first_column);
    map.cells[at_row * map.width + at_column] = percent[static_cast<std::size_t>(value - min_)];
  });
  return map;
}

GridMap build_occupancy_grid(const std::vector<ScanAtPose>& scans,
                             const OccupancyGridParams& params) {
  OccupancyGrid grid(params);
  for (const ScanAtPose& posed : scans) {
    if (posed.scan == nullptr) throw std::invalid_argument("occupancy grid: a scan is missing");
    grid.add(*posed.scan, posed.map_T_laser);
  }
  return grid.rasterise();
}

}  // namespace falko_slam
