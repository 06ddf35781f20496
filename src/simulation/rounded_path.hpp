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

  /// With corners that a wheel can steer along: each point becomes the mean of the way around it,
  /// a window of this length [m], narrower towards the ends, which stay where they are.
  RoundedPath smoothed(double window) const;

  double length() const { return way_.back(); }  ///< [m]
  /// At this length of way; straight on beyond the end.
  Eigen::Vector2d at(double way) const;
  /// The way to the nearest point, looked for between `from` and `to` only [m].
  double nearest(const Eigen::Vector2d& point, double from, double to) const;

 private:
  RoundedPath() = default;
  void append(const Eigen::Vector2d& point);
  Eigen::Vector2d mean_around(double way, double half) const;
  /// `room`: what the corner may take of the lines before and after it [m].
  void append_corner(const Eigen::Vector2d& before, const Eigen::Vector2d& corner,
                     const Eigen::Vector2d& after, double radius, double room);

  std::vector<Eigen::Vector2d> points_;
  std::vector<double> way_;  // to each point
};

}  // namespace falko_slam
