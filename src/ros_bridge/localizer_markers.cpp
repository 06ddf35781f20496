// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_markers.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "falko_slam/localization/line_model.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "marker_list.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr MarkerLook kMapReflectors{"reflectors", 1.0F, 0.8F, 0.1F, 1.0F, 0.35};
constexpr MarkerLook kFeatures{"features", 0.3F, 0.6F, 1.0F, 1.0F, 0.20};
constexpr MarkerLook kStatePoints{"state_points", 0.1F, 0.9F, 0.9F, 1.0F, 0.20};
constexpr MarkerLook kStateFaces{"state_faces", 0.1F, 0.9F, 0.9F, 1.0F, 0.10};
constexpr MarkerLook kUsed{"used", 0.0F, 0.9F, 0.3F, 0.8F, 0.04};
constexpr MarkerLook kStrangers{"strangers", 0.9F, 0.2F, 0.1F, 0.7F, 0.04};
constexpr MarkerLook kPose{"pose", 0.0F, 0.9F, 0.3F, 1.0F, 0.12};
constexpr MarkerLook kDeviation{"deviation", 0.7F, 0.3F, 1.0F, 0.6F, 0.05};
constexpr double kDeviations = 3.0;

void add_map(const LandmarkMap& map, const std_msgs::Header& header, MarkerArray& markers) {
  Marker reflectors = marker_of(kMapReflectors, Marker::SPHERE_LIST, header);
  Marker features = marker_of(kFeatures, Marker::CUBE_LIST, header);
  for (const MapLandmark& landmark : map.landmarks) {
    add_point(landmark.kind == LandmarkKind::kReflector ? reflectors : features, landmark.position);
  }
  append(std::move(reflectors), markers);
  append(std::move(features), markers);
}

void add_state(const std::vector<ActiveLandmark>& in_state, const std_msgs::Header& header,
               MarkerArray& markers) {
  Marker points = marker_of(kStatePoints, Marker::CUBE_LIST, header);
  Marker faces = marker_of(kStateFaces, Marker::LINE_LIST, header);
  for (const ActiveLandmark& landmark : in_state) {
    if (!landmark.is_line) {
      add_point(points, landmark.middle);
      continue;
    }
    const Eigen::Vector2d middle = nearest_point(landmark.line, landmark.middle);
    const Eigen::Vector2d half = landmark.half_length * direction_of(landmark.line);
    add_point(faces, middle - half);
    add_point(faces, middle + half);
  }
  append(std::move(points), markers);
  append(std::move(faces), markers);
}

void add_sight(const LocalizerReport& report, const Pose2& map_T_laser,
               const std_msgs::Header& header, MarkerArray& markers) {
  Marker used = marker_of(kUsed, Marker::LINE_LIST, header);
  Marker strangers = marker_of(kStrangers, Marker::LINE_LIST, header);
  for (const SeenLandmark& seen : report.seen) {
    const bool is_used = seen.verdict == ObservationVerdict::kUsed;
    if (!is_used && !fits_nothing(seen.verdict)) continue;
    Marker& marker = is_used ? used : strangers;
    add_point(marker, map_T_laser.translation());
    add_point(marker, map_T_laser * seen.in_laser);
  }
  append(std::move(used), markers);
  append(std::move(strangers), markers);
}

Marker ellipse_of(const PoseEstimate& estimate, const std_msgs::Header& header) {
  Marker marker = marker_of(kDeviation, Marker::CYLINDER, header);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(
      estimate.covariance.topLeftCorner<2, 2>());
  const Eigen::Vector2d across = solver.eigenvectors().col(1);
  marker.pose = to_message(Pose2(estimate.pose.translation(), std::atan2(across.y(), across.x())));
  const auto axis = [&](Eigen::Index i) {
    return std::max(0.01, 2.0 * kDeviations * std::sqrt(std::max(0.0, solver.eigenvalues()(i))));
  };
  marker.scale.x = axis(1);
  marker.scale.y = axis(0);
  return marker;
}

void add_pose(const LocalizerReport& report, const std_msgs::Header& header, MarkerArray& markers) {
  Marker arrow = marker_of(kPose, Marker::ARROW, header);
  arrow.scale.x = 1.0;
  Marker ellipse = marker_of(kDeviation, Marker::CYLINDER, header);
  if (report.map_T_base) {
    arrow.pose = to_message(report.map_T_base->pose);
    ellipse = ellipse_of(*report.map_T_base, header);
  } else {
    arrow.action = ellipse.action = Marker::DELETE;
  }
  markers.markers.push_back(arrow);
  markers.markers.push_back(ellipse);
}

}  // namespace

MarkerArray localizer_markers(const LocalizerReport& report, const LandmarkMap& map,
                              const std::vector<ActiveLandmark>& in_state,
                              const Pose2& base_T_laser, const std::string& map_frame) {
  const std_msgs::Header header = header_of(report.stamp, map_frame);
  MarkerArray markers;
  add_map(map, header, markers);
  const bool placed = report.map_T_base.has_value();
  add_sight(placed ? report : LocalizerReport(),
            placed ? report.map_T_base->pose * base_T_laser : Pose2(), header, markers);
  add_state(in_state, header, markers);
  add_pose(report, header, markers);
  return markers;
}

}  // namespace falko_slam
