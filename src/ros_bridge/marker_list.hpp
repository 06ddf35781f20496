// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the markers of all nodelets have in common.
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <cstdint>
#include <utility>

namespace falko_slam {

/// The name of a marker, and how it looks.
struct MarkerLook {
  const char* name;
  float red, green, blue, alpha;
  double size;  ///< of a point, or a line's width [m]
};

inline visualization_msgs::Marker marker_of(const MarkerLook& look, std::int32_t type,
                                            const std_msgs::Header& header) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = look.name;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = look.size;
  marker.color.r = look.red;
  marker.color.g = look.green;
  marker.color.b = look.blue;
  marker.color.a = look.alpha;
  return marker;
}

inline geometry_msgs::Point point_at(const Eigen::Vector2d& place) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  return point;
}

inline void add_point(visualization_msgs::Marker& marker, const Eigen::Vector2d& place) {
  marker.points.push_back(point_at(place));
}

/// Only what has points is drawn; the rest takes away what was there.
inline void append(visualization_msgs::Marker marker, visualization_msgs::MarkerArray& array) {
  using visualization_msgs::Marker;
  marker.action = marker.points.empty() ? Marker::DELETE : Marker::ADD;
  array.markers.push_back(std::move(marker));
}

}  // namespace falko_slam
