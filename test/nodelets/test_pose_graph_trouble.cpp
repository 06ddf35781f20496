// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <falko_slam/LoadState.h>
#include <falko_slam/SaveMap.h>
#include <falko_slam/SaveState.h>
#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/map/map_file.hpp"
#include "slam_way.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class PoseGraphNode : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(PoseGraphNode, AnswersBeforeThereIsAnyKeyframe) {
  LoadedSlam slam("empty", folder_.path());
  ASSERT_TRUE(slam.ready());
  nav_msgs::GetMap get;
  EXPECT_FALSE(ros::service::call(slam.node.resolveName("dynamic_map"), get));
  EXPECT_EQ(slam.of_file<SaveMap>("save_map", "a").message, "there is no map yet");
  EXPECT_EQ(slam.of_file<SaveState>("save_state", "a").message, "there is no keyframe to save");
  EXPECT_TRUE(folder_.names().empty());
  const auto reset = slam.call<std_srvs::Trigger>("reset").response;
  EXPECT_TRUE(reset.success);
  EXPECT_EQ(reset.message, "0 keyframes forgotten");
}

TEST_F(PoseGraphNode, NamesTheTransformThatIsMissingAndGoesOnWhenItComes) {
  LoadedSlam slam("without_tf", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  for (int i = 0; i < 70; ++i) {
    client.advance(0.125);
    client.send(client.scan_at({}));
  }
  ASSERT_TRUE(client.diagnosed("no transform from without_tf_laser to without_tf_odom", kWarn))
      << client.status.message;
  EXPECT_TRUE(client.to_map.empty());
  Way way;
  way.drive(client, 5);
  EXPECT_TRUE(all_came(client));
}

TEST_F(PoseGraphNode, NamesAFrameThatTfDoesNotKnow) {
  LoadedSlam slam("other_frame", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  Way way;
  way.drive(client, 3);
  for (int i = 0; i < 70; ++i) {
    client.advance(0.125);
    client.send_odometry(way.odometry());
    sensor_msgs::LaserScan scan = client.scan_at(way.here());
    scan.header.frame_id = i < 35 ? "another_laser" : "";
    client.send(scan);
  }
  ASSERT_TRUE(client.diagnosed("scans dropped: ", kWarn)) << client.status.message;
  EXPECT_TRUE(client.status.message.find("another_laser") != std::string::npos ||
              client.status.message.find("names no frame") != std::string::npos)
      << client.status.message;
  way.drive(client, 5);
  EXPECT_TRUE(all_came(client));
}

TEST_F(PoseGraphNode, StopsItsTransformAfterThreeSecondsWithoutScans) {
  LoadedSlam slam("silence", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  Way way;
  way.drive(client, 5);
  ASSERT_TRUE(all_came(client));
  const ros::Time last = client.stamp;
  for (int i = 0; i < 100; ++i) {
    client.advance(0.1);
    client.send_odometry(way.odometry());
    test::spin_for(0.002);
  }
  EXPECT_NEAR((client.to_map.back().header.stamp - last).toSec(), 3.1, 0.3);
  EXPECT_TRUE(client.diagnosed("no message on /silence/scan for 1", kWarn))
      << client.status.message;
  const std::size_t before = client.to_map.size();
  way.drive(client, 5);
  ASSERT_TRUE(all_came(client));
  EXPECT_LT(error_of(client, kStart * way.here()), 0.05);
  EXPECT_GT(client.to_map.size(), before);
  expect_stamps_rise(client.to_map);
}

// A bag in a loop: the same drive again, from the beginning of its time.
TEST_F(PoseGraphNode, FindsItsPlaceAgainWhenTimeJumpsBack) {
  LoadedSlam slam("looped_bag", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  const double begin = client.stamp.toSec();
  Way first;
  first.drive(client, 60);
  ASSERT_TRUE(all_came(client));
  expect_stamps_rise(client.to_map);
  client.to_map.clear();
  client.set_time(begin);
  test::spin_for(0.1);
  EXPECT_TRUE(client.to_map.empty());
  client.poses.clear();
  Way second;
  second.drive(client, 60);
  ASSERT_TRUE(all_came(client)) << client.status.message;
  EXPECT_LT(client.poses.size(), 60U);  // it had to find its place first
  EXPECT_LT(error_of(client, kStart * second.here()), 0.1);
  ASSERT_FALSE(client.to_map.empty());
  expect_stamps_rise(client.to_map);
  EXPECT_LT(client.to_map.back().header.stamp.toSec(), begin + 10.0);
}

TEST_F(PoseGraphNode, PausesAndGoesOnWhereItStood) {
  LoadedSlam slam("paused", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  Way way;
  way.drive(client, 10);
  ASSERT_TRUE(all_came(client));
  std_srvs::SetBool pause;
  pause.request.data = 1;
  EXPECT_TRUE(slam.call("pause", pause).response.success);
  const std::size_t before = client.poses.size();
  for (int i = 0; i < 40; ++i) client.step(way.here(), way.odometry());
  EXPECT_TRUE(client.diagnosed("paused", kWarn)) << client.status.message;
  EXPECT_EQ(client.poses.size(), before);
  EXPECT_GT(client.to_map.back().header.stamp, client.stamp);  // and is sent all the same
  pause.request.data = 0;
  const auto running = slam.call("pause", pause).response;
  EXPECT_TRUE(running.success);
  EXPECT_EQ(running.message, "running");
  way.drive(client, 5);
  ASSERT_TRUE(all_came(client));
  EXPECT_LT(error_of(client, kStart * way.here()), 0.05);
}

TEST_F(PoseGraphNode, BeginsADriveIfItWasMovedWhilePaused) {
  LoadedSlam slam("moved", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  Way way;
  way.drive(client, 10);
  ASSERT_TRUE(all_came(client));
  std_srvs::SetBool pause;
  pause.request.data = 1;
  slam.call("pause", pause);
  way.drive(client, 20);
  pause.request.data = 0;
  slam.call("pause", pause);
  way.drive(client, 2);
  EXPECT_TRUE(client.diagnosed("place in the map is not known", kWarn)) << client.status.message;
}

TEST_F(PoseGraphNode, BeginsANewMapAfterAReset) {
  LoadedSlam slam("reset", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  bool cleared = false;
  const auto subscriber = client.node().subscribe<visualization_msgs::MarkerArray>(
      "graph_markers", 10, [&](const visualization_msgs::MarkerArrayConstPtr& message) {
        for (const auto& marker : message->markers) {
          cleared = cleared || marker.action == visualization_msgs::Marker::DELETEALL;
        }
      });
  Way way;
  way.drive(client, 20);
  ASSERT_TRUE(all_came(client));
  ASSERT_TRUE(spin_until([&] { return client.path && client.path->poses.size() > 5; }));
  EXPECT_FALSE(cleared);
  const auto reset = slam.call<std_srvs::Trigger>("reset").response;
  EXPECT_TRUE(reset.success);
  EXPECT_NE(reset.message.find("keyframes forgotten"), std::string::npos) << reset.message;
  EXPECT_TRUE(spin_until([&] { return cleared && client.path->poses.empty(); }));
  way.drive(client, 5);
  ASSERT_TRUE(all_came(client));
  // The map is the odometry's frame again.
  EXPECT_LT(error_of(client, way.odometry()), 0.05);
  expect_stamps_rise(client.to_map);
}

TEST_F(PoseGraphNode, WorksWithoutOdometryAndSaysSo) {
  XmlRpc::XmlRpcValue more;
  more["use_odometry"] = false;
  LoadedSlam slam("scans_alone", folder_.path(), more);
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  const std::vector<Pose2> lap = office_path(0.1);
  for (std::size_t i = 0; i < 50; ++i) {
    client.advance(0.125);
    client.send(client.scan_at(lap[i]));
    test::spin_for(0.004);
  }
  ASSERT_TRUE(all_came(client));
  EXPECT_LT(error_of(client, lap[0].inverse() * lap[49]), 0.05);
  ASSERT_FALSE(client.to_map.empty());
  EXPECT_EQ(client.to_map.back().child_frame_id, "scans_alone_base");
  EXPECT_TRUE(client.diagnosed("without odometry", kOk)) << client.status.message;
}

TEST_F(PoseGraphNode, SurvivesBadScans) {
  LoadedSlam slam("bad_scans", folder_.path());
  SlamClient& client = slam.client;
  ASSERT_TRUE(slam.ready());
  Way way;
  way.drive(client, 3);
  sensor_msgs::LaserScan scan = client.scan_at({});
  scan.ranges.clear();
  client.send(scan);
  EXPECT_TRUE(client.diagnosed("unusable scan", diagnostic_msgs::DiagnosticStatus::ERROR));
  scan = client.scan_at({});
  std::fill(scan.ranges.begin(), scan.ranges.end(), std::nanf(""));
  client.send(scan);
  way.drive(client, 3);
  EXPECT_TRUE(all_came(client));
}

TEST_F(PoseGraphNode, DoesNotLoadWithBadParametersOrAStateThatIsNone) {
  nodelet::Loader loader(false);
  const ros::NodeHandle node("/refused_slam");
  const auto loads = [&] { return loader.load("/refused_slam", "falko_slam/PoseGraph", {}, {}); };
  node.setParam("map/resolution", 7.0);
  EXPECT_FALSE(loads());
  node.setParam("map/resolution", 0.05);
  node.setParam("state", folder_.write("state", "FALKOSTA"));
  EXPECT_FALSE(loads());
  node.setParam("state", "");
  EXPECT_TRUE(loads());
}

}  // namespace
}  // namespace falko_slam
