// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_markers.hpp"

#include <utility>

#include "marker_list.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;

// Refused candidates whose scans fit less are not worth a line.
constexpr double kLeastScore = 0.5;

constexpr MarkerLook kEarlier{"earlier_keyframes", 0.4F, 0.4F, 0.7F, 1.0F, 0.1};
constexpr MarkerLook kPlaces{"keyframes", 0.2F, 0.5F, 1.0F, 1.0F, 0.1};
constexpr MarkerLook kRejected{"rejected_loops", 0.6F, 0.6F, 0.6F, 0.4F, 0.02};
constexpr MarkerLook kAccepted{"accepted_loops", 0.0F, 0.9F, 0.2F, 1.0F, 0.05};

void shorten(std::deque<geometry_msgs::Point>& points, std::size_t most) {
  while (points.size() > most) points.pop_front();
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
  keyframes_.push_back(point_at(record.odom_T_laser.translation()));
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
  lines.push_back(point_at(memory.record(source).odom_T_laser.translation()));
  lines.push_back(point_at(memory.record(best.target).odom_T_laser.translation()));
  shorten(lines, 2 * (accepted ? kMostAccepted : kMostRejected));
}

visualization_msgs::MarkerArray LoopMarkers::markers(const ros::Time& stamp) const {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = odom_frame_;
  visualization_msgs::MarkerArray array;
  const auto add = [&](const MarkerLook& look, std::int32_t type, const Points& points) {
    Marker marker = marker_of(look, type, header);
    marker.points.assign(points.begin(), points.end());
    append(std::move(marker), array);
  };
  add(kEarlier, Marker::POINTS, earlier_keyframes_);
  add(kPlaces, Marker::POINTS, keyframes_);
  add(kRejected, Marker::LINE_LIST, rejected_);
  add(kAccepted, Marker::LINE_LIST, accepted_);
  return array;
}

}  // namespace falko_slam
