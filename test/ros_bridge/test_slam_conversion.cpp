// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/slam_conversion.hpp"

#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/graph_markers.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "support/slam_drive.hpp"

namespace falko_slam {
namespace {

std_msgs::Header header() {
  std_msgs::Header result;
  result.frame_id = "map";
  result.stamp = ros::Time(50.0);
  return result;
}

TEST(MapMessage, HoldsWhatPlannersExpect) {
  GridMap map;
  map.width = 3;
  map.height = 2;
  map.resolution = 0.1;
  map.map_T_origin = Pose2(-1.0, 2.0, 0.0);
  map.cells = {-1, 3, 50, 90, 100, 0};
  const nav_msgs::OccupancyGrid message = to_message(map, header());
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.info.width, 3U);
  EXPECT_EQ(message.info.height, 2U);
  EXPECT_FLOAT_EQ(message.info.resolution, 0.1F);
  EXPECT_EQ(message.info.origin.position.x, -1.0);
  EXPECT_EQ(message.info.origin.orientation.w, 1.0);
  EXPECT_EQ(message.data, (std::vector<std::int8_t>{-1, 0, -1, 100, 100, 0}));
}

TEST(PathMessage, IsThatOfTheBaseAtTheKeyframes) {
  FeatureSlam slam;
  test::drive_office(slam, 12);
  const nav_msgs::Path path = path_of(slam, header());
  ASSERT_EQ(path.poses.size(), slam.keyframes());
  ASSERT_GT(slam.keyframes(), 2U);
  const std::vector<Pose2> truth = office_path(0.25);
  EXPECT_NEAR(path.poses[0].pose.position.x, truth[0].x(), 1e-6);
  EXPECT_NEAR(path.poses[0].pose.position.y, truth[0].y(), 1e-6);
  EXPECT_EQ(path.poses[1].header.stamp, to_ros(slam.record({1}).stamp));
  EXPECT_EQ(path.poses[1].header.frame_id, "map");
}

TEST(ConstraintMessage, TellsTheVerdict) {
  FeatureSlam slam;
  test::drive_office(slam, 8);
  SlamClosure closure;
  closure.source = {1};
  closure.target = {0};
  closure.target_T_source = Pose2(0.5, 0.0, 0.1);
  const auto verdict_of = [&](const std::string& verdict, bool accepted) {
    closure.verdict = verdict;
    closure.accepted = accepted;
    const LoopConstraint message = to_message(closure, slam);
    EXPECT_EQ(message.reason, verdict);
    EXPECT_EQ(message.accepted != 0, accepted);
    return message.verdict;
  };
  EXPECT_EQ(verdict_of("accepted", true), LoopConstraint::ACCEPTED);
  EXPECT_EQ(verdict_of("pending", false), LoopConstraint::PENDING);
  EXPECT_EQ(verdict_of("scans_do_not_agree", false), LoopConstraint::DISAGREES);
  EXPECT_EQ(verdict_of("against_odometry", false), LoopConstraint::INCONSISTENT);
  EXPECT_EQ(verdict_of(name_of(LoopVerdict::kAmbiguous), false), LoopConstraint::AMBIGUOUS);
  EXPECT_EQ(to_message(closure, slam).target_stamp, to_ros(slam.record({0}).stamp));
}

TEST(ClosureNews, AreNewClosuresAndOtherVerdicts) {
  ClosureNews news;
  std::vector<SlamClosure> closures(2);
  EXPECT_EQ(news.changed(closures), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(news.changed(closures).empty());
  closures[0].verdict = "accepted";
  closures.emplace_back();
  EXPECT_EQ(news.changed(closures), (std::vector<std::size_t>{0, 2}));
  news.reset();
  EXPECT_EQ(news.changed(closures).size(), 3U);
}

TEST(GraphMarkers, DrawNodesAndConstraints) {
  FeatureSlam slam;
  test::drive_office(slam, 200);  // more than once round
  std::map<std::string, visualization_msgs::Marker> markers;
  for (const auto& marker : graph_markers(slam, header()).markers) markers[marker.ns] = marker;
  EXPECT_EQ(markers["keyframes"].points.size(), slam.keyframes());
  EXPECT_EQ(markers["keyframes"].type, visualization_msgs::Marker::SPHERE_LIST);
  EXPECT_EQ(markers["odometry"].points.size(), 2 * (slam.keyframes() - 1));
  EXPECT_EQ(markers["odometry"].type, visualization_msgs::Marker::LINE_LIST);
  EXPECT_GT(markers["registrations"].points.size(), 0U);
  EXPECT_GT(markers["closures"].points.size(), 0U);
  EXPECT_EQ(markers["closures"].header.frame_id, "map");
  EXPECT_LE(markers["refused_closures"].points.size(), 2 * kMostRefusedClosures);
}

TEST(GraphMarkers, OfAnEmptyGraphTakeAwayWhatWasThere) {
  for (const auto& marker : graph_markers(FeatureSlam(), header()).markers) {
    EXPECT_EQ(marker.action, visualization_msgs::Marker::DELETE) << marker.ns;
  }
  const auto none = no_markers(header()).markers;
  ASSERT_EQ(none.size(), 1U);
  EXPECT_EQ(none[0].action, visualization_msgs::Marker::DELETEALL);
}

}  // namespace
}  // namespace falko_slam
