// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <optional>
#include <string>

#include "falko_slam/slam/transform_slew.hpp"

namespace falko_slam {

struct MapTransformParams {
  std::string map_frame = "map";
  std::string child_frame = "odom";
  double tolerance = 0.1;  ///< stamped so much ahead of now [s]
  double timeout = 3.0;    ///< without news for so long nothing is told any more [s]
  TransformSlewParams slew;
};

/// What is to be sent as map_T_child: nothing before it is known, nothing when it is stale, never
/// one stamp twice, and never a later stamp before an earlier one. Not thread-safe.
class MapTransform {
 public:
  explicit MapTransform(const MapTransformParams& params);

  /// A scan has shown it; `child_T_base` is where the vehicle is, for the slew.
  void set(const Pose2& map_T_child, const Pose2& child_T_base, const ros::Time& now);
  /// It holds although no scan comes, or does not any more.
  void hold(bool held) { held_ = held; }
  /// It is not known any more.
  void reset();
  /// Time has jumped back: stamps may, too.
  void rewind();

  const std::string& child_frame() const { return params_.child_frame; }
  /// To be sent at this time, if anything is.
  std::optional<geometry_msgs::TransformStamped> at(const ros::Time& now);

 private:
  bool is_stale(const ros::Time& now) const;

  MapTransformParams params_;
  TransformSlew slew_;
  bool known_ = false;
  bool held_ = false;
  ros::Time news_;
  ros::Time last_stamp_;
  ros::Time last_now_;
};

}  // namespace falko_slam
