// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <deque>
#include <string>

#include "falko_slam/place_recognition/keyframe_memory.hpp"

namespace falko_slam {

/// For rviz, in the odometry's frame: keyframes of the current drive as points ("keyframes"), those
/// of earlier ones ("earlier_keyframes"), accepted loops as green lines ("accepted_loops"), and in
/// grey the best candidates of other keyframes if the scans fitted and were refused all the same
/// ("rejected_loops").
///
/// Bounded: of each kind the newest stay. Earlier drives lie where their own odometry had them.
class LoopMarkers {
 public:
  explicit LoopMarkers(std::string odom_frame);

  void clear();
  void add(const KeyframeRecord& record);
  void add(const KeyframeMemory& memory, KeyframeId source, const LoopDetection& detection);

  visualization_msgs::MarkerArray markers(const ros::Time& stamp) const;

  static constexpr std::size_t kMostKeyframes = 20000;
  static constexpr std::size_t kMostAccepted = 5000;
  static constexpr std::size_t kMostRejected = 300;

 private:
  using Points = std::deque<geometry_msgs::Point>;

  std::string odom_frame_;
  std::size_t drive_ = 0;
  Points keyframes_;
  Points earlier_keyframes_;
  Points accepted_;  // two for each loop
  Points rejected_;
};

}  // namespace falko_slam
