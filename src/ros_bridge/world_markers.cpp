// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/world_markers.hpp"

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/laser_scanner.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

Marker lines_of(const char* name, const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = Marker::LINE_LIST;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = 0.08;
  marker.color.a = 1.0F;
  return marker;
}

void add_point(Marker& marker, const Eigen::Vector2d& place) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  marker.points.push_back(point);
}

// A circle as so many lines.
void add_circle(Marker& marker, const Cylinder& cylinder, const Pose2& world_T_shape) {
  constexpr int kSides = 12;
  const auto corner = [&](int i) {
    return world_T_shape * Pose2(cylinder.center, kTwoPi * i / kSides) *
           Eigen::Vector2d(cylinder.radius, 0.0);
  };
  for (int i = 0; i < kSides; ++i) {
    add_point(marker, corner(i));
    add_point(marker, corner(i + 1));
  }
}

void add_shape(Marker& marker, const Shape& shape, const Pose2& world_T_shape) {
  for (const Face& face : shape.faces) {
    add_point(marker, world_T_shape * face.from);
    add_point(marker, world_T_shape * face.to);
  }
  for (const Cylinder& cylinder : shape.cylinders) add_circle(marker, cylinder, world_T_shape);
}

Marker reflectors_of(const std::vector<Cylinder>& reflectors, const std_msgs::Header& header) {
  Marker marker = lines_of("reflectors", header);
  marker.type = Marker::SPHERE_LIST;
  marker.scale.x = marker.scale.y = marker.scale.z = 0.3;
  marker.color.r = 1.0F;
  marker.color.g = 0.8F;
  for (const Cylinder& reflector : reflectors) add_point(marker, reflector.center);
  return marker;
}

}  // namespace

MarkerArray world_markers(const World& world, double seconds, const std_msgs::Header& header) {
  Marker fixed = lines_of("world", header);
  fixed.color.r = fixed.color.g = fixed.color.b = 0.1F;
  Marker things = lines_of("things", header);
  things.color.r = 0.9F;
  things.color.g = 0.4F;
  add_shape(fixed, world.fixed, {});
  for (const Body& body : world.bodies) {
    if (seconds < body.appears || seconds >= body.disappears) continue;
    add_shape(things, body.shape, pose_at(body.motion, seconds));
  }
  Marker reflectors = reflectors_of(falko_slam::reflectors_of(world), header);
  MarkerArray array;
  for (Marker* marker : {&fixed, &things, &reflectors}) {
    marker->action = marker->points.empty() ? Marker::DELETE : Marker::ADD;
    array.markers.push_back(std::move(*marker));
  }
  return array;
}

}  // namespace falko_slam
