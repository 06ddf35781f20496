// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace falko_slam {

/// Straight lines with rounded corners, as points close to each other.
class RoundedPath {
 public:
  /// Corners are rounded by arcs of this radius [m], or less where the lines are too short.
  RoundedPath(const std::vector<Eigen::Vector2d>& through, double corner_radius);

  double length() const { return way_.back(); }  ///< [m]
  /// At this length of way; straight on beyond the end.
  Eigen::Vector2d at(double way) const;
  /// The way to the nearest point, looked for between `from` and `to` only [m].
  double nearest(const Eigen::Vector2d& point, double from, double to) const;

 private:
  void append(const Eigen::Vector2d& point);
  void append_corner(const Eigen::Vector2d& before, const Eigen::Vector2d& corner,
                     const Eigen::Vector2d& after, double radius);

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> way_;  // to each point
};

}  // namespace falko_slam
