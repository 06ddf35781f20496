// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "falko_slam/map/occupancy_grid.hpp"

namespace falko_slam {

/// A scan that is shared, so that a map can be drawn while SLAM goes on, and where it was taken.
struct MappedScan {
  std::shared_ptr<const LaserScan> scan;
  Pose2 map_T_laser;
};

/// An occupancy grid that is kept up with a graph: where the scans drawn so far have not moved the
/// new ones are added, else all are drawn anew. Either way the result is that of
/// build_occupancy_grid, bit by bit. Not thread-safe.
class GrowingMap {
 public:
  explicit GrowingMap(const OccupancyGridParams& params = {});

  /// Throws as OccupancyGrid does.
  GridMap draw(const std::vector<MappedScan>& scans);

  /// How often all scans had to be drawn anew.
  std::size_t redrawn() const { return redrawn_; }

 private:
  bool begins_with_drawn(const std::vector<MappedScan>& scans) const;

  OccupancyGrid grid_;
  std::vector<MappedScan> drawn_;
  std::size_t redrawn_ = 0;
};

}  // namespace falko_slam
