// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/world_markers.hpp"

#include <gtest/gtest.h>

#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const Marker& marker_of(const MarkerArray& array, const std::string& name) {
  for (const Marker& marker : array.markers) {
    if (marker.ns == name) return marker;
  }
  throw std::out_of_range(name);
}

World world_with_a_mover() {
  World world = test::empty_world();
  add_box(world.fixed, {}, {10.0, 6.0}, test::kMatt);
  world.fixed.cylinders.push_back({{2.0, 1.0}, 0.04, test::kReflector});
  Body body;
  add_box(body.shape, {}, {1.0, 1.0}, test::kMatt);
  body.motion = {{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}}, 1.0, BodyMotion::Repeat::kOnce};
  body.disappears = 3.0;
  world.bodies.push_back(body);
  return world;
}

TEST(WorldMarkers, DrawWhatStandsWithItsReflectors) {
  std_msgs::Header header;
  header.frame_id = "world";
  const MarkerArray array = world_markers(world_with_a_mover(), 0.0, header);

  EXPECT_EQ(marker_of(array, "world").points.size(), 2U * (4U + 12U));
  ASSERT_EQ(marker_of(array, "reflectors").points.size(), 1U);
  EXPECT_EQ(marker_of(array, "reflectors").points[0].x, 2.0);
  for (const Marker& marker : array.markers) EXPECT_EQ(marker.header.frame_id, "world");
}

TEST(WorldMarkers, DrawThingsWhereTheyAreWhileTheyAreThere) {
  const World world = world_with_a_mover();
  const MarkerArray later = world_markers(world, 2.0, {});
  const MarkerArray gone = world_markers(world, 3.0, {});

  double middle = 0.0;
  const Marker& things = marker_of(later, "things");
  ASSERT_EQ(things.points.size(), 8U);
  for (const auto& point : things.points) middle += point.x / 8.0;
  EXPECT_NEAR(middle, 2.0, 1e-9);
  EXPECT_EQ(marker_of(gone, "things").action, Marker::DELETE);
}

}  // namespace
}  // namespace falko_slam
