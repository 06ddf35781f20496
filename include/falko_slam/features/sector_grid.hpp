// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

namespace falko_slam {

/// The distance of two of `count` sectors around the circle: |d_theta| of \cite kallasi2017 (3.7).
inline int sector_distance(int a, int b, int count) {
  const int difference = a < b ? b - a : a - b;
  return difference < count - difference ? difference : count - difference;
}

/// Quantises directions into equal circular sectors, counter-clockwise from the x axis.
///
/// Sector s holds the directions with floor(count / (2 pi) * atan2(y, x)) = s modulo `count`:
/// Eqs. (3.5), (3.6) and (3.13) of \cite kallasi2017 (whose tan^-1 of a quotient means atan2).
/// No trigonometry per point: directions are compared through |x| + |y| = 1, the "diamond angle".
class SectorGrid {
 public:
  /// Throws std::invalid_argument unless 2 <= count <= 1024.
  explicit SectorGrid(int count);

  int count() const { return count_; }

  /// In [0, count); 0 for the zero vector.
  int sector(float x, float y) const { return sector_at(diamond_angle(x, y)); }

  /// Monotonic in the direction, from 0 at +x over 1 at +y and 2 at -x to 4; 0 for the zero vector.
  static float diamond_angle(float x, float y) {
    const float sum = std::abs(x) + std::abs(y);
    const float ratio = sum > 0.0F ? y / sum : 0.0F;
    const float start = x < 0.0F ? 2.0F : (y < 0.0F ? 4.0F : 0.0F);
    return start + (x < 0.0F ? -ratio : ratio);
  }

  /// The sector of a diamond angle in [0, 4].
  int sector_at(float angle) const {
    const int sector = first_[static_cast<std::size_t>(static_cast<int>(angle * cells_per_unit_))];
    return sector + static_cast<int>(angle >= start_[static_cast<std::size_t>(sector) + 1]);
  }

 private:
  int count_;
  float cells_per_unit_;
  std::vector<float> start_;  // diamond angle at which a sector starts; one more at the end
  std::vector<int> first_;    // per cell of the diamond angle, which is narrower than any sector:
                              // the sector at its start
};

/// Numbers of points by sector.
class SectorHistogram {
 public:
  explicit SectorHistogram(int count) : points_(static_cast<std::size_t>(count)) {}

  void clear();
  void add(int sector) {
    if (points_[static_cast<std::size_t>(sector)]++ == 0) occupied_.push_back(sector);
  }

  /// Sum over all pairs of points of |d_theta|, Eqs. (3.8)-(3.9). Computed from the counts: the
  /// cost grows with the number of occupied sectors, not with that of the points.
  long pairwise_distance() const;

 private:
  std::vector<int> points_;
  std::vector<int> occupied_;
};

}  // namespace falko_slam
