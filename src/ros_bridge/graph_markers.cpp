// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/graph_markers.hpp"

#include "marker_list.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr MarkerLook kNodes{"keyframes", 0.2F, 0.5F, 1.0F, 1.0F, 0.15};
constexpr MarkerLook kOdometry{"odometry", 0.3F, 0.5F, 0.9F, 0.8F, 0.04};
constexpr MarkerLook kRegistrations{"registrations", 0.5F, 0.5F, 0.6F, 0.4F, 0.02};
constexpr MarkerLook kClosures{"closures", 0.0F, 0.8F, 0.2F, 0.7F, 0.03};
constexpr MarkerLook kRefused{"refused_closures", 0.9F, 0.2F, 0.1F, 0.4F, 0.02};

void add_refused(Marker& marker, const FeatureSlam& slam) {
  const std::vector<SlamClosure>& closures = slam.closures();
  for (auto closure = closures.rbegin();
       closure != closures.rend() && marker.points.size() < 2 * kMostRefusedClosures; ++closure) {
    if (closure->accepted || !slam.is_mapped(closure->source) || !slam.is_mapped(closure->target)) {
      continue;
    }
    add_point(marker, slam.map_T_laser(closure->source).translation());
    add_point(marker, slam.map_T_laser(closure->target).translation());
  }
}

}  // namespace

MarkerArray graph_markers(const FeatureSlam& slam, const std_msgs::Header& header) {
  Marker keyframes = marker_of(kNodes, Marker::SPHERE_LIST, header);
  Marker odometry = marker_of(kOdometry, Marker::LINE_LIST, header);
  Marker registrations = marker_of(kRegistrations, Marker::LINE_LIST, header);
  Marker closures = marker_of(kClosures, Marker::LINE_LIST, header);
  Marker refused = marker_of(kRefused, Marker::LINE_LIST, header);
  const PoseGraph graph = slam.graph();
  for (const GraphNode& node : graph.nodes)
    add_point(keyframes, slam.map_T_laser(node.id).translation());
  for (const GraphConstraint& constraint : graph.constraints) {
    Marker& lines = constraint.kind == ConstraintKind::kOdometry       ? odometry
                    : constraint.kind == ConstraintKind::kRegistration ? registrations
                                                                       : closures;
    add_point(lines, slam.map_T_laser(constraint.from).translation());
    add_point(lines, slam.map_T_laser(constraint.to).translation());
  }
  add_refused(refused, slam);
  MarkerArray array;
  for (Marker* marker : {&keyframes, &odometry, &registrations, &closures, &refused}) {
    append(std::move(*marker), array);
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
