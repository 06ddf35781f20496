// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_footprint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace falko_slam {
namespace {

constexpr std::int64_t kFine = 2048;  // parts of a cell's side

// A point in parts of a cell. Odd numbers: no point lies on a border, all cells are closed or open
// alike, and what a beam crosses turns with it.
struct FinePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

struct Beam {
  FinePoint end;
  bool hit = false;
};

FinePoint fine_point(const Eigen::Vector2d& point, double resolution) {
  const double scale = 0.5 * static_cast<double>(kFine) / resolution;
  return {2 * static_cast<std::int64_t>(std::floor(point.x() * scale)) + 1,
          2 * static_cast<std::int64_t>(std::floor(point.y() * scale)) + 1};
}

// Rounds down, also below zero.
std::int32_t cell_of(std::int64_t fine) {
  return static_cast<std::int32_t>(fine >= 0 ? fine / kFine : -((kFine - 1 - fine) / kFine));
}

// How far the beam frees cells; 0: it says nothing.
double seen_range(const LaserScan& scan, std::size_t beam, const OccupancyGridParams& params) {
  switch (scan.status[beam]) {
    case BeamStatus::kValid:
      return std::isfinite(scan.ranges[beam]) ? std::min(scan.ranges[beam], params.max_free_range)
                                              : 0.0;
    case BeamStatus::kNoReturn:
    case BeamStatus::kTooFar:
      return std::min(params.no_return_free_range, scan.range_max);
    case BeamStatus::kZero:
    case BeamStatus::kTooNear:
    case BeamStatus::kErroneous:
      break;
  }
  return 0.0;
}

std::vector<Beam> beams_of(const LaserScan& scan, const Pose2& map_T_laser,
                           const OccupancyGridParams& params) {
  std::vector<Beam> beams;
  beams.reserve(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const bool hit = scan.valid(i) && scan.ranges[i] <= params.max_range;
    const double range = hit ? scan.ranges[i] : seen_range(scan, i, params);
    if (!(range > 0.0)) continue;
    const double bearing = scan.bearing(i);
    const Eigen::Vector2d end(range * std::cos(bearing), range * std::sin(bearing));
    beams.push_back({fine_point(map_T_laser * end, params.resolution), hit});
  }
  return beams;
}

ScanFootprint empty_footprint(const FinePoint& laser, const std::vector<Beam>& beams) {
  FinePoint low = laser;
  FinePoint high = laser;
  for (const Beam& beam : beams) {
    low = {std::min(low.x, beam.end.x), std::min(low.y, beam.end.y)};
    high = {std::max(high.x, beam.end.x), std::max(high.y, beam.end.y)};
  }
  ScanFootprint footprint;
  footprint.column = cell_of(low.x);
  footprint.row = cell_of(low.y);
  footprint.width = cell_of(high.x) - footprint.column + 1;
  footprint.height = cell_of(high.y) - footprint.row + 1;
  footprint.marks.resize(static_cast<std::size_t>(footprint.width) *
                         static_cast<std::size_t>(footprint.height));
  return footprint;
}

// One axis of a beam on its way through the cells.
struct Axis {
  std::int64_t length = 0;    // in parts of a cell, never negative
  std::int64_t to_first = 0;  // from the start to the first border it crosses
  std::ptrdiff_t crossings = 0;
  std::ptrdiff_t step = 1;  // of the index at a crossing
};

Axis axis_of(std::int64_t from, std::int64_t to, std::ptrdiff_t stride) {
  const std::int64_t within = from - kFine * cell_of(from);
  const std::ptrdiff_t cells = cell_of(to) - cell_of(from);
  if (to >= from) return {to - from, kFine - within, cells, stride};
  return {from - to, within, -cells, -stride};
}

// Marks all cells but the last one and returns the index of that.
std::ptrdiff_t trace(const Axis& x, const Axis& y, std::ptrdiff_t at, std::uint8_t* marks) {
  // Positive where the beam comes to its next border along y before that along x: the sign of
  // to_x / x.length - to_y / y.length.
  std::int64_t lead = x.to_first * y.length - y.to_first * x.length;
  const std::int64_t after_x = kFine * y.length;
  const std::int64_t after_y = -kFine * x.length;
  for (std::ptrdiff_t left = x.crossings + y.crossings; left > 0; --left) {
    marks[at] = static_cast<std::uint8_t>(marks[at] | ScanFootprint::kPassed);
    const bool along_x = lead < 0;
    at += along_x ? x.step : y.step;
    lead += along_x ? after_x : after_y;
  }
  return at;
}

}  // namespace

ScanFootprint trace_scan(const LaserScan& scan, const Pose2& map_T_laser,
                         const OccupancyGridParams& params) {
  const std::vector<Beam> beams = beams_of(scan, map_T_laser, params);
  if (beams.empty()) return {};
  const FinePoint laser = fine_point(map_T_laser.translation(), params.resolution);
  ScanFootprint footprint = empty_footprint(laser, beams);
  const std::ptrdiff_t start = std::ptrdiff_t{cell_of(laser.y) - footprint.row} * footprint.width +
                               (cell_of(laser.x) - footprint.column);
  for (const Beam& beam : beams) {
    const Axis x = axis_of(laser.x, beam.end.x, 1);
    const Axis y = axis_of(laser.y, beam.end.y, footprint.width);
    std::uint8_t& last =
        footprint.marks[static_cast<std::size_t>(trace(x, y, start, footprint.marks.data()))];
    last =
        static_cast<std::uint8_t>(last | (beam.hit ? ScanFootprint::kHit : ScanFootprint::kPassed));
  }
  return footprint;
}

}  // namespace falko_slam
