// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace falko_slam {

/// What two straight lines in place of one explain of a row of points, and where the second begins.
struct LineBreak {
  std::size_t second = 0;  ///< its first point
  double gain = 0.0;       ///< fall of chi-square; 0: there are too few points
  double weight = 0.0;     ///< of all points
};

/// Finds it for points (x, y) of weight 1 / variance of y, in the order of x. O(points).
class LineBreakSearch {
 public:
  void add(double x, double y, double weight) {
    all_.add(x, y, weight);
    until_.push_back(all_);
  }

  LineBreak best() const {
    constexpr std::size_t kFewest = 3;  // of either line
    LineBreak best;
    for (std::size_t second = kFewest; second + kFewest <= until_.size(); ++second) {
      const Sums& left = until_[second - 1];
      const double gain = all_.residual() - left.residual() - all_.without(left).residual();
      if (gain > best.gain) best = {second, gain, all_.weight};
    }
    return best;
  }

 private:
  struct Sums {
    double weight = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

    void add(double px, double py, double w) {
      weight += w;
      x += w * px;
      y += w * py;
      xx += w * px * px;
      xy += w * px * py;
      yy += w * py * py;
    }
    Sums without(const Sums& other) const {
      return {weight - other.weight, x - other.x,   y - other.y,
              xx - other.xx,         xy - other.xy, yy - other.yy};
    }
    // Of the line that fits best.
    double residual() const {
      const double spread = xx - x * x / weight, cross = xy - x * y / weight;
      const double total = yy - y * y / weight;
      return std::max(0.0, spread > 1e-12 ? total - cross * cross / spread : total);
    }
  };

  Sums all_;
  std::vector<Sums> until_;
};

}  // namespace falko_slam
