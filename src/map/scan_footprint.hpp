// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "falko_slam/map/occupancy_grid.hpp"

namespace falko_slam {

/// What one scan says of the cells around it.
///
/// Cell (i, j) of the plane covers [i, i + 1) x [j, j + 1) times the resolution. `marks` is
/// row-major from cell (column, row), the lower left corner of the rectangle that all beams stay
/// in.
struct ScanFootprint {
  /// Bits: a cell may be passed by one beam and hit by another.
  static constexpr std::uint8_t kPassed = 1;
  static constexpr std::uint8_t kHit = 2;

  std::int32_t column = 0;
  std::int32_t row = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<std::uint8_t> marks;
};

/// All cells whose interior a beam crosses, from the laser to the point where it ends or is cut
/// off; at a corner of four cells a beam steps along y first. Points are rounded to 1/1024 of a
/// cell, from there on all is exact. Needs valid parameters and a finite pose.
ScanFootprint trace_scan(const LaserScan& scan, const Pose2& map_T_laser,
                         const OccupancyGridParams& params);

}  // namespace falko_slam
