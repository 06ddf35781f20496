// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// Where a vehicle is on a map on which nothing follows it for a while: the last pose there, and
/// since then what odometry says, with a deviation that grows with the way. After a long way, or
/// where odometry was interrupted, it is not known.
class PoseHandover {
 public:
  /// Odometry is `odom_frame` -> `base_frame` of these transforms, which must outlive this.
  PoseHandover(const tf2::BufferCore& transforms, std::string odom_frame, std::string base_frame);

  /// The pose on `map` from now on, in the place of one that was kept before. It is not known if it
  /// is older than 2 s, cannot be read, or is of a time of which odometry knows nothing.
  void keep(const std::string& map, const geometry_msgs::PoseWithCovarianceStamped& map_T_base,
            ros::Time now);

  /// Adds up the way; to be called every second or so. The pose is not known any more after 30 m,
  /// or where odometry is gone, went back in time or jumped by 5 m: it is another one then.
  void follow();

  /// When odometry was heard last, with a deviation of 2 cm and 3 % of the way, and of 5 mrad and
  /// 5 mrad/m, beside that of the pose that was kept. Empty where it is not known. To be called
  /// after `follow`.
  std::optional<geometry_msgs::PoseWithCovarianceStamped> pose_on(const std::string& map) const;

 private:
  struct Kept {
    std::string map, map_frame;
    PoseEstimate map_T_base;
    Pose2 odom_T_base;    ///< there
    Pose2 odom_T_latest;  ///< of the base
    ros::Time latest;
    double way = 0.0;  ///< since then [m]
  };

  geometry_msgs::TransformStamped odom_T_base(ros::Time stamp) const;

  const tf2::BufferCore& transforms_;
  std::string odom_frame_, base_frame_;
  std::optional<Kept> kept_;
};

}  // namespace falko_slam
