// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/simulation/layout_follower.hpp"
#include "rounded_path.hpp"

namespace falko_slam {

/// One path of a layout, and where on it a vehicle is.
class PathTracking {
 public:
  PathTracking(const FollowStep& step, const LayoutFollowerParams& params,
               const Eigen::Vector2d& begin);

  /// Takes up where base_link is.
  void move_to(const Pose2& map_T_base);

  double remaining() const { return path_.length() - way_; }  ///< [m]; negative: beyond the end
  double cross_track() const { return cross_track_; }         ///< left of the path [m]

  /// Of the way of base_link, to come back to the path at this speed [1/m].
  double curvature(double speed) const;
  /// The fastest here, with all curves ahead and the end in view; without sign [m/s].
  double speed_limit() const;

  bool backward() const { return step_.backward; }
  /// Its end, heading as the vehicle should: against the path where it drives backwards.
  Pose2 map_T_end() const;
  bool ends_in_curve() const;

 private:
  double heading_at(double way) const;
  double path_curvature(double way) const;

  FollowStep step_;
  LayoutFollowerParams params_;
  RoundedPath path_;
  double way_ = 0.0;  // of the path's point that is nearest [m]
  double cross_track_ = 0.0;
  double heading_error_ = 0.0;
};

}  // namespace falko_slam
