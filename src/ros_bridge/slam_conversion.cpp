// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/slam_conversion.hpp"

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

std::uint8_t verdict_of(const SlamClosure& closure) {
  if (closure.accepted) return LoopConstraint::ACCEPTED;
  if (closure.verdict == "pending") return LoopConstraint::PENDING;
  if (closure.verdict == "scans_do_not_agree") return LoopConstraint::DISAGREES;
  for (std::uint8_t code = 0; code < LoopConstraint::ACCEPTED; ++code) {
    if (closure.verdict == name_of(static_cast<LoopVerdict>(code))) return code;
  }
  return LoopConstraint::INCONSISTENT;
}

}  // namespace

nav_msgs::OccupancyGrid to_message(const GridMap& map, const std_msgs::Header& header) {
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(map.resolution);
  message.info.width = static_cast<std::uint32_t>(map.width);
  message.info.height = static_cast<std::uint32_t>(map.height);
  message.info.origin = to_message(map.map_T_origin);
  message.data = trinary(map).cells;
  return message;
}

nav_msgs::Path path_of(const FeatureSlam& slam, const std_msgs::Header& header) {
  nav_msgs::Path path;
  path.header = header;
  for (std::size_t i = 0; i < slam.keyframes(); ++i) {
    if (!slam.is_mapped({i})) continue;
    const KeyframeRecord& record = slam.record({i});
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = header.frame_id;
    pose.header.stamp = to_ros(record.stamp);
    pose.pose = to_message(slam.map_T_laser({i}) * record.base_T_laser.inverse());
    path.poses.push_back(pose);
  }
  return path;
}

LoopConstraint to_message(const SlamClosure& closure, const FeatureSlam& slam) {
  LoopConstraint message;
  message.source = closure.source.value;
  message.target = closure.target.value;
  message.source_stamp = to_ros(closure.stamp);
  message.target_stamp = to_ros(slam.record(closure.target).stamp);
  message.accepted = static_cast<std::uint8_t>(closure.accepted);
  message.verdict = verdict_of(closure);
  message.reason = closure.verdict;
  message.target_T_source.pose = to_message(closure.target_T_source);
  message.score = closure.score;
  return message;
}

std::vector<std::size_t> ClosureNews::changed(const std::vector<SlamClosure>& closures) {
  std::vector<std::size_t> numbers;
  told_.resize(closures.size());
  for (std::size_t i = 0; i < closures.size(); ++i) {
    if (told_[i] == closures[i].verdict) continue;
    told_[i] = closures[i].verdict;
    numbers.push_back(i);
  }
  return numbers;
}

}  // namespace falko_slam
