// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/graph_markers.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

struct Look {
  const char* name;
  float red, green, blue, alpha;
  double size;  // of a sphere or a line's width [m]
};

constexpr Look kKeyframes{"keyframes", 0.2F, 0.5F, 1.0F, 1.0F, 0.15};
constexpr Look kOdometry{"odometry", 0.3F, 0.5F, 0.9F, 0.8F, 0.04};
constexpr Look kRegistrations{"registrations", 0.5F, 0.5F, 0.6F, 0.4F, 0.02};
constexpr Look kClosures{"closures", 0.0F, 0.8F, 0.2F, 0.7F, 0.03};
constexpr Look kRefused{"refused_closures", 0.9F, 0.2F, 0.1F, 0.4F, 0.02};

Marker marker_of(const Look& look, std::int32_t type, const std_msgs::Header& header) {
  Marker marker;
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

void add_point(Marker& marker, const Pose2& pose) {
  geometry_msgs::Point point;
  point.x = pose.x();
  point.y = pose.y();
  marker.points.push_back(point);
}

void add_refused(Marker& marker, const FeatureSlam& slam) {
  const std::vector<SlamClosure>& closures = slam.closures();
  for (auto closure = closures.rbegin();
       closure != closures.rend() && marker.points.size() < 2 * kMostRefusedClosures; ++closure) {
    if (closure->accepted || !slam.is_mapped(closure->source) || !slam.is_mapped(closure->target)) {
      continue;
    }
    add_point(marker, slam.map_T_laser(closure->source));
    add_point(marker, slam.map_T_laser(closure->target));
  }
}

}  // namespace

MarkerArray graph_markers(const FeatureSlam& slam, const std_msgs::Header& header) {
  Marker keyframes = marker_of(kKeyframes, Marker::SPHERE_LIST, header);
  Marker odometry = marker_of(kOdometry, Marker::LINE_LIST, header);
  Marker registrations = marker_of(kRegistrations, Marker::LINE_LIST, header);
  Marker closures = marker_of(kClosures, Marker::LINE_LIST, header);
  Marker refused = marker_of(kRefused, Marker::LINE_LIST, header);
  const PoseGraph graph = slam.graph();
  for (const GraphNode& node : graph.nodes) add_point(keyframes, slam.map_T_laser(node.id));
  for (const GraphConstraint& constraint : graph.constraints) {
    Marker& lines = constraint.kind == ConstraintKind::kOdometry       ? odometry
                    : constraint.kind == ConstraintKind::kRegistration ? registrations
                                                                       : closures;
    add_point(lines, slam.map_T_laser(constraint.from));
    add_point(lines, slam.map_T_laser(constraint.to));
  }
  add_refused(refused, slam);
  MarkerArray array;
  for (Marker* marker : {&keyframes, &odometry, &registrations, &closures, &refused}) {
    marker->action = marker->points.empty() ? Marker::DELETE : Marker::ADD;
    array.markers.push_back(std::move(*marker));
  }
  return array;
}

MarkerArray no_markers(const std_msgs::Header& header) {
  MarkerArray array;
  array.markers.emplace_back();
  array.markers.back().header = header;
  array.markers.back().action = Marker::DELETEALL;
  return array;
}

}  // namespace falko_slam
