// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/localization/odometry_track.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// Whether a scan shows what the one before it showed: where it does not, the vehicle was carried
/// elsewhere, whatever odometry and landmarks say. Needs no map. Not thread-safe.
class SceneMemory {
 public:
  explicit SceneMemory(const Pose2& base_T_laser) : base_T_laser_(base_T_laser) {}

  /// The share of the points of the scan before that this one shows, at least a few of them in
  /// sight; empty where there is none or it is more than 2 s old. Remembers this one.
  std::optional<double> share_seen_again(const LaserScan& scan, Time instant,
                                         const OdometryTrack& track);

  void clear() { points_.clear(); }

 private:
  double share_in(const LaserScan& scan, const Pose2& laser_T_odom, std::size_t& compared) const;
  void remember(const LaserScan& scan, const Pose2& odom_T_laser);

  Pose2 base_T_laser_;
  std::vector<Eigen::Vector2d> points_;  // of the scan before, in odom
  Time stamp_{};
};

}  // namespace falko_slam
