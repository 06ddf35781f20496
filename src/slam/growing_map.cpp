// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/growing_map.hpp"

#include <algorithm>

namespace falko_slam {
namespace {

bool same(const MappedScan& a, const MappedScan& b) {
  return a.scan == b.scan && a.map_T_laser.translation() == b.map_T_laser.translation() &&
         a.map_T_laser.theta() == b.map_T_laser.theta();
}

}  // namespace

GrowingMap::GrowingMap(const OccupancyGridParams& params) : grid_(params) {}

bool GrowingMap::begins_with_drawn(const std::vector<MappedScan>& scans) const {
  return drawn_.size() <= scans.size() &&
         std::equal(drawn_.begin(), drawn_.end(), scans.begin(), same);
}

GridMap GrowingMap::draw(const std::vector<MappedScan>& scans) {
  if (!begins_with_drawn(scans)) {
    grid_ = OccupancyGrid(grid_.params());
    drawn_.clear();
    ++redrawn_;
  }
  for (std::size_t i = drawn_.size(); i < scans.size(); ++i) {
    grid_.add(*scans[i].scan, scans[i].map_T_laser);
    drawn_.push_back(scans[i]);
  }
  return grid_.rasterise();
}

}  // namespace falko_slam
