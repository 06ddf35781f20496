// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/sector_grid.hpp"

#include <limits>
#include <stdexcept>
#include <string>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

SectorGrid::SectorGrid(int count) : count_(count) {
  if (count < 2 || count > 1024) {
    throw std::invalid_argument("sectors = " + std::to_string(count) + ": must be in [2, 1024]");
  }
  for (int s = 0; s < count; ++s) {
    const double angle = kTwoPi * s / count;
    start_.push_back(
        diamond_angle(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))));
  }
  start_.push_back(std::numeric_limits<float>::infinity());

  const int cells = 4 * count;
  cells_per_unit_ = static_cast<float>(count);
  int sector = 0;
  for (int cell = 0; cell <= cells; ++cell) {  // one spare: the angle may round up to 4
    while (static_cast<float>(cell) / cells_per_unit_ >=
           start_[static_cast<std::size_t>(sector) + 1])
      ++sector;
    first_.push_back(sector);
  }
}

void SectorHistogram::clear() {
  for (const int sector : occupied_) points_[static_cast<std::size_t>(sector)] = 0;
  occupied_.clear();
}

long SectorHistogram::pairwise_distance() const {
  const int count = static_cast<int>(points_.size());
  long sum = 0;
  for (std::size_t i = 0; i < occupied_.size(); ++i) {
    const long points = points_[static_cast<std::size_t>(occupied_[i])];
    for (std::size_t j = 0; j < i; ++j) {
      sum += points * points_[static_cast<std::size_t>(occupied_[j])] *
             sector_distance(occupied_[i], occupied_[j], count);
    }
  }
  return sum;
}

}  // namespace falko_slam
