// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_markers.hpp"

#include <gtest/gtest.h>

#include <map>

#include "support/loop_memory.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;

std::map<std::string, Marker> by_name(const LoopMarkers& markers) {
  std::map<std::string, Marker> found;
  for (const Marker& marker : markers.markers(ros::Time(5)).markers) found[marker.ns] = marker;
  return found;
}

TEST(LoopMarkers, DrawKeyframesAndLoopsInTheOdometrysFrame) {
  const KeyframeMemory memory = test::room_memory();
  LoopMarkers markers("odom");
  for (const KeyframeRecord& record : memory.records()) markers.add(record);
  markers.add(memory, {2}, test::room_loop());

  auto found = by_name(markers);
  ASSERT_EQ(found.size(), 4U);
  for (const auto& [name, marker] : found) {
    EXPECT_EQ(marker.header.frame_id, "odom") << name;
    EXPECT_EQ(marker.header.stamp, ros::Time(5)) << name;
  }
  EXPECT_EQ(found["keyframes"].points.size(), 1U);
  EXPECT_EQ(found["earlier_keyframes"].points.size(), 2U);
  ASSERT_EQ(found["accepted_loops"].points.size(), 2U);
  EXPECT_GT(found["accepted_loops"].color.g, 0.5F);
  EXPECT_EQ(found["accepted_loops"].points[1].x, memory.record({0}).odom_T_laser.x());
  EXPECT_EQ(found["rejected_loops"].action, Marker::DELETE);
}

TEST(LoopMarkers, DrawRefusedLoopsInGreyIfTheScansFitted) {
  const KeyframeMemory memory = test::room_memory();
  LoopMarkers markers("odom");
  LoopDetection detection = test::room_loop();
  detection.candidates[0].verdict = LoopVerdict::kAmbiguous;
  detection.candidates[0].scan_score = 0.3;
  markers.add(memory, {2}, detection);
  EXPECT_EQ(by_name(markers)["rejected_loops"].action, Marker::DELETE);
  detection.candidates[0].scan_score = 0.9;
  markers.add(memory, {2}, detection);
  const Marker grey = by_name(markers)["rejected_loops"];
  EXPECT_EQ(grey.points.size(), 2U);
  EXPECT_EQ(grey.color.r, grey.color.g);
  markers.add(memory, {2}, LoopDetection());
}

TEST(LoopMarkers, DeleteWhatIsNotThereAnyMore) {
  LoopMarkers markers("odom");
  markers.add(test::room_memory().records()[0]);
  EXPECT_EQ(by_name(markers)["keyframes"].action, Marker::ADD);
  EXPECT_EQ(by_name(markers)["accepted_loops"].action, Marker::DELETE);
  markers.clear();
  EXPECT_EQ(by_name(markers)["keyframes"].action, Marker::DELETE);
}

TEST(LoopMarkers, KeepTheNewest) {
  LoopMarkers markers("odom");
  KeyframeRecord record;
  for (std::size_t i = 0; i < LoopMarkers::kMostKeyframes + 10; ++i) {
    record.odom_T_laser = {static_cast<double>(i), 0.0, 0.0};
    markers.add(record);
  }
  auto found = by_name(markers);
  EXPECT_EQ(found["keyframes"].points.size(), LoopMarkers::kMostKeyframes);
  EXPECT_EQ(found["keyframes"].points[0].x, 10.0);
}

}  // namespace
}  // namespace falko_slam
