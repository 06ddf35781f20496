// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_markers.hpp"

#include <utility>

namespace falko_slam {
namespace {

using visualization_msgs::Marker;

// Refused candidates whose scans fit less are not worth a line.
constexpr double kLeastScore = 0.5;

geometry_msgs::Point position_of(const Pose2& pose) {
  geometry_msgs::Point point;
  point.x = pose.x();
  point.y = pose.y();
  return point;
}

std_msgs::ColorRGBA color(float red, float green, float blue, float alpha = 1.0F) {
  std_msgs::ColorRGBA result;
  result.r = red;
  result.g = green;
  result.b = blue;
  result.a = alpha;
  return result;
}

void shorten(std::deque<geometry_msgs::Point>& points, std::size_t most) {
  while (points.size() > most) points.pop_front();
}

Marker list_marker(const char* name, std::int32_t type, double scale,
                   const std_msgs::ColorRGBA& its_color,
                   const std::deque<geometry_msgs::Point>& points) {
  Marker marker;
  marker.ns = name;
  marker.type = type;
  marker.action = points.empty() ? Marker::DELETE : Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = scale;
  marker.color = its_color;
  marker.points.assign(points.begin(), points.end());
  return marker;
}

}  // namespace

LoopMarkers::LoopMarkers(std::string odom_frame) : odom_frame_(std::move(odom_frame)) {}

void LoopMarkers::clear() {
  drive_ = 0;
  for (Points* points : {&keyframes_, &earlier_keyframes_, &accepted_, &rejected_}) points->clear();
}

void LoopMarkers::add(const KeyframeRecord& record) {
  if (record.drive != drive_) {
    earlier_keyframes_.insert(earlier_keyframes_.end(), keyframes_.begin(), keyframes_.end());
    keyframes_.clear();
    drive_ = record.drive;
  }
  keyframes_.push_back(position_of(record.odom_T_laser));
  shorten(keyframes_, kMostKeyframes);
  shorten(earlier_keyframes_, kMostKeyframes);
}

void LoopMarkers::add(const KeyframeMemory& memory, KeyframeId source,
                      const LoopDetection& detection) {
  if (detection.candidates.empty()) return;
  const LoopCandidate& best = detection.candidates.front();
  const bool accepted = best.verdict == LoopVerdict::kAccepted;
  if (!accepted && best.scan_score < kLeastScore) return;
  Points& lines = accepted ? accepted_ : rejected_;
  lines.push_back(position_of(memory.record(source).odom_T_laser));
  lines.push_back(position_of(memory.record(best.target).odom_T_laser));
  shorten(lines, 2 * (accepted ? kMostAccepted : kMostRejected));
}

visualization_msgs::MarkerArray LoopMarkers::markers(const ros::Time& stamp) const {
  visualization_msgs::MarkerArray array;
  array.markers = {
      list_marker("earlier_keyframes", Marker::POINTS, 0.1, color(0.4F, 0.4F, 0.7F),
                  earlier_keyframes_),
      list_marker("keyframes", Marker::POINTS, 0.1, color(0.2F, 0.5F, 1.0F), keyframes_),
      list_marker("rejected_loops", Marker::LINE_LIST, 0.02, color(0.6F, 0.6F, 0.6F, 0.4F),
                  rejected_),
      list_marker("accepted_loops", Marker::LINE_LIST, 0.05, color(0.0F, 0.9F, 0.2F), accepted_)};
  for (Marker& marker : array.markers) {
    marker.header.stamp = stamp;
    marker.header.frame_id = odom_frame_;
  }
  return array;
}

}  // namespace falko_slam
