// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_markers.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace falko_slam {
namespace {

using visualization_msgs::Marker;

std::map<std::string, Marker> drawn(const LocalizerReport& report, const LandmarkMap& map,
                                    const std::vector<ActiveLandmark>& in_state) {
  std::map<std::string, Marker> found;
  for (const Marker& marker : localizer_markers(report, map, in_state, Pose2(), "map").markers) {
    EXPECT_EQ(marker.header.frame_id, "map") << marker.ns;
    found[marker.ns] = marker;
  }
  return found;
}

TEST(LocalizerMarkers, DrawTheMapWithoutAPose) {
  LandmarkMap map;
  map.landmarks.resize(3);
  map.landmarks[2].kind = LandmarkKind::kFeature;

  auto found = drawn(LocalizerReport(), map, {});

  EXPECT_EQ(found["reflectors"].points.size(), 2U);
  EXPECT_EQ(found["features"].points.size(), 1U);
  EXPECT_EQ(found["pose"].action, Marker::DELETE);
}

TEST(LocalizerMarkers, DrawFacesOfTheStateFromEndToEnd) {
  ActiveLandmark face, corner;
  face.is_line = true;
  face.line = {0.0, 3.0, Eigen::Vector2d::Zero()};
  face.middle = {3.1, 4.0};
  face.half_length = 0.8;
  corner.middle = {1.0, 2.0};

  auto found = drawn(LocalizerReport(), LandmarkMap(), {face, corner});

  ASSERT_EQ(found["state_points"].points.size(), 1U);
  EXPECT_EQ(found["state_points"].points[0].y, 2.0);
  ASSERT_EQ(found["state_faces"].points.size(), 2U);
  for (const auto& point : found["state_faces"].points) EXPECT_NEAR(point.x, 3.0, 1e-12);
  EXPECT_NEAR(found["state_faces"].points[0].y, 4.8, 1e-12);
  EXPECT_NEAR(found["state_faces"].points[1].y, 3.2, 1e-12);
}

TEST(LocalizerMarkers, TakeAwayLandmarksThatTheStateNoLongerHolds) {
  auto found = drawn(LocalizerReport(), LandmarkMap(), {});

  EXPECT_EQ(found["state_points"].action, Marker::DELETE);
  EXPECT_EQ(found["state_faces"].action, Marker::DELETE);
}

}  // namespace
}  // namespace falko_slam
