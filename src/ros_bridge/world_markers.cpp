// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/world_markers.hpp"

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/laser_scanner.hpp"
#include "marker_list.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr MarkerLook kFixed{"world", 0.1F, 0.1F, 0.1F, 1.0F, 0.08};
constexpr MarkerLook kThings{"things", 0.9F, 0.4F, 0.0F, 1.0F, 0.08};
constexpr MarkerLook kTrueReflectors{"reflectors", 1.0F, 0.8F, 0.0F, 1.0F, 0.3};

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

}  // namespace

MarkerArray world_markers(const World& world, double seconds, const std_msgs::Header& header) {
  Marker fixed = marker_of(kFixed, Marker::LINE_LIST, header);
  Marker things = marker_of(kThings, Marker::LINE_LIST, header);
  Marker reflectors = marker_of(kTrueReflectors, Marker::SPHERE_LIST, header);
  add_shape(fixed, world.fixed, {});
  for (const Body& body : world.bodies) {
    if (seconds < body.appears || seconds >= body.disappears) continue;
    add_shape(things, body.shape, pose_at(body.motion, seconds));
  }
  for (const Cylinder& reflector : reflectors_of(world)) add_point(reflectors, reflector.center);
  MarkerArray array;
  for (Marker* marker : {&fixed, &things, &reflectors}) append(std::move(*marker), array);
  return array;
}

}  // namespace falko_slam
