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

// Once round the office and on to where it began.
class RoundTheOffice : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TemporaryFolder>();
    slam_ = std::make_unique<LoadedSlam>("office", folder_->path());
    ASSERT_TRUE(slam_->ready());
    way_ = std::make_unique<Way>();
    way_->drive(client(), way_->lap() + 30);
    ASSERT_TRUE(all_came(client()));
  }
  static void TearDownTestSuite() {
    slam_.reset();
    folder_.reset();
    way_.reset();
  }

  static SlamClient& client() { return slam_->client; }
  static Pose2 map_T_world() { return kStart; }

  static inline std::unique_ptr<test::TemporaryFolder> folder_;
  static inline std::unique_ptr<LoadedSlam> slam_;
  static inline std::unique_ptr<Way> way_;
};

TEST_F(RoundTheOffice, FollowsTheVehicleBetterThanItsOdometry) {
  EXPECT_EQ(client().last_pose().header.frame_id, "office_map");
  EXPECT_LT(error_of(client(), map_T_world() * way_->here()), 0.05);
  const Pose2 odometry = (map_T_world() * way_->here()).inverse() * way_->odometry();
  EXPECT_GT(odometry.translation().norm(), 0.15);
  EXPECT_GT(client().last_pose().pose.covariance[0], 0.0);
  EXPECT_EQ(client().poses.size(), way_->driven());
}

TEST_F(RoundTheOffice, SendsOneTransformAheadOfTimeAndNoneTwice) {
  const auto& sent = client().to_map;
  ASSERT_GT(sent.size(), way_->driven() / 2);
  expect_stamps_rise(sent);
  EXPECT_EQ(sent.back().child_frame_id, "office_odom");
  EXPECT_NEAR((sent.back().header.stamp - client().stamp).toSec(), 0.1, 0.05);
  EXPECT_EQ(client().map_broadcasters.size(), 1U);
  EXPECT_LT(error_of(client(), in_plane(sent.back().transform) * way_->odometry()), 0.02);
}

TEST_F(RoundTheOffice, DrawsMapAndPath) {
  ASSERT_TRUE(spin_until(
      [&] { return client().map && client().path && client().path->poses.size() > 30; }));
  const nav_msgs::OccupancyGrid& map = *client().map;
  EXPECT_EQ(map.header.frame_id, "office_map");
  EXPECT_GT(map.info.width, 320U);
  for (const int value : {-1, 0, 100}) {
    EXPECT_GT(std::count(map.data.begin(), map.data.end(), value), 100) << value;
  }
  const auto& poses = client().path->poses;
  const Pose2 first = pose_of(poses.front().pose);
  EXPECT_LT(((map_T_world() * way_->truth(0)).inverse() * first).log().norm(), 0.02);
}

TEST_F(RoundTheOffice, ClosesTheRoundWithTrueConstraints) {
  std::size_t accepted = 0;
  const double begin = (client().poses.front().header.stamp).toSec();
  const auto laser = [&](const ros::Time& stamp) {
    const auto i = static_cast<std::size_t>(std::lround((stamp.toSec() - begin) / 0.125));
    return way_->truth(i) * SlamClient::kMount;
  };
  for (const LoopConstraint& constraint : client().constraints) {
    EXPECT_FALSE(constraint.reason.empty());
    if (!constraint.accepted) continue;
    ++accepted;
    const Pose2 error = laser(constraint.source_stamp).inverse() * laser(constraint.target_stamp) *
                        pose_of(constraint.target_T_source.pose);
    EXPECT_LT(error.translation().norm(), 0.1);
  }
  EXPECT_GT(accepted, 3U);
}

TEST_F(RoundTheOffice, DrawsTheGraphForWhoAsks) {
  visualization_msgs::MarkerArrayConstPtr markers;
  const auto subscriber = client().node().subscribe<visualization_msgs::MarkerArray>(
      "graph_markers", 1, [&](const auto& message) { markers = message; });
  ASSERT_TRUE(spin_until([&] { return markers != nullptr; }));
  EXPECT_TRUE(std::any_of(markers->markers.begin(), markers->markers.end(), [](const auto& marker) {
    return marker.ns == "closures" && marker.points.size() > 6;
  }));
}

TEST_F(RoundTheOffice, ReportsThatAllIsWell) {
  EXPECT_TRUE(client().diagnosed("keyframes", kOk)) << client().status.message;
  EXPECT_EQ(client().value("anchored in the map"), "yes");
  EXPECT_EQ(client().value("scans dropped for want of time"), "0");
}

TEST_F(RoundTheOffice, SavesTheMapThatItGives) {
  const auto given = slam_->call<nav_msgs::GetMap>("dynamic_map").response.map;
  EXPECT_EQ(given.header.frame_id, "office_map");
  for (const char* name : {"halls/one", "two.yaml"}) {
    const auto saved = slam_->of_file<SaveMap>("save_map", name);
    ASSERT_TRUE(saved.success) << saved.message;
  }
  const GridMap map = read_map(folder_->file("halls/one.yaml"));
  EXPECT_EQ(map.width, given.info.width);
  EXPECT_EQ(trinary(map).cells, given.data);
  EXPECT_NEAR(map.map_T_origin.x(), given.info.origin.position.x, 1e-6);
  EXPECT_EQ(read_whole_file(folder_->file("two.png")).substr(1, 3), "PNG");
  EXPECT_EQ(read_map(folder_->file("two.yaml")).cells, map.cells);
}

TEST_F(RoundTheOffice, RefusesFilesOutsideOfItsFolder) {
  for (const char* name : {"../a", "/tmp/a", "", "x/../../a"}) {
    const auto map = slam_->of_file<SaveMap>("save_map", name);
    EXPECT_FALSE(map.success) << name;
    EXPECT_NE(map.message.find("file name '" + std::string(name)), std::string::npos)
        << map.message;
    EXPECT_FALSE(slam_->of_file<SaveState>("save_state", name).success) << name;
    EXPECT_FALSE(slam_->of_file<LoadState>("load_state", name).success) << name;
  }
}

TEST_F(RoundTheOffice, KeepsItsMapWhenAStateCannotBeLoaded) {
  ASSERT_TRUE(slam_->of_file<SaveState>("save_state", "whole.slam").success);
  std::string bytes = read_whole_file(folder_->file("whole.slam"));
  folder_->write("short.slam", bytes.substr(0, bytes.size() / 2));
  bytes[bytes.size() / 3] = static_cast<char>(bytes[bytes.size() / 3] ^ 16);
  folder_->write("flipped.slam", bytes);
  for (const char* name : {"short.slam", "flipped.slam", "missing.slam"}) {
    const auto loaded = slam_->of_file<LoadState>("load_state", name);
    EXPECT_FALSE(loaded.success) << name;
    EXPECT_NE(loaded.message.find(folder_->file(name)), std::string::npos) << loaded.message;
  }
  const std::size_t before = client().poses.size();
  way_->drive(client(), 4);
  ASSERT_TRUE(all_came(client()));
  EXPECT_EQ(client().poses.size(), before + 4);
  EXPECT_LT(error_of(client(), map_T_world() * way_->here()), 0.05);
}

// Elsewhere, and with an odometry that has nothing to do with the one before.
TEST_F(RoundTheOffice, GoesOnWithALoadedStateWhereItRecognisesThePlace) {
  const auto saved = slam_->of_file<SaveState>("save_state", "office.slam");
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_GT(saved.keyframes, 50U);
  LoadedSlam later("later", folder_->path());
  ASSERT_TRUE(later.ready());
  const auto loaded = later.of_file<LoadState>("load_state", "office.slam");
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(loaded.keyframes, saved.keyframes);

  Way way(Pose2(300.0, 0.0, -2.0), 40);
  way.drive(later.client, 2);
  EXPECT_TRUE(later.client.diagnosed("place in the map is not known", kWarn))
      << later.client.status.message;
  EXPECT_TRUE(later.client.poses.empty());
  EXPECT_TRUE(later.client.to_map.empty());
  while (later.client.poses.empty() && way.driven() < 120) way.drive(later.client, 5);
  way.drive(later.client, 10);
  ASSERT_TRUE(all_came(later.client));
  EXPECT_LT(error_of(later.client, map_T_world() * way.here()), 0.1);
  ASSERT_FALSE(later.client.to_map.empty());
  // One that went out while the last scan was worked on is not sent again until time goes on.
  later.client.advance(1.0);
  ASSERT_TRUE(
      spin_until([&] { return later.client.to_map.back().header.stamp >= later.client.stamp; }));
  const Pose2 map_T_odom = in_plane(later.client.to_map.back().transform);
  EXPECT_LT(error_of(later.client, map_T_odom * way.odometry()), 0.02);
}

TEST_F(RoundTheOffice, BeginsWithTheStateThatAParameterNames) {
  ASSERT_TRUE(slam_->of_file<SaveState>("save_state", "first.slam").success);
  XmlRpc::XmlRpcValue more;
  more["state"] = "first.slam";
  LoadedSlam later("with_state", folder_->path(), more);
  ASSERT_TRUE(later.ready());
  EXPECT_TRUE(spin_until([&] { return later.client.map != nullptr; }));
}

class LaunchedSlam : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Ways, LaunchedSlam, ::testing::Values("as_nodelet", "as_node"),
                         [](const auto& way) { return std::string(way.param); });

TEST_P(LaunchedSlam, FollowsTheVehicle) {
  SlamClient client(GetParam());
  ASSERT_TRUE(client.connected(3));
  client.advance(1.0);
  Way way;
  way.drive(client, 10);
  ASSERT_TRUE(all_came(client));
  EXPECT_LT(error_of(client, kStart * way.here()), 0.05);
  ASSERT_TRUE(spin_until([&] { return client.map && !client.map_broadcasters.empty(); }));
  EXPECT_EQ(client.map_broadcasters.size(), 1U);

  client.send_map_transform();
  EXPECT_TRUE(client.diagnosed("sends it, too", kWarn)) << client.status.message;
  EXPECT_NE(client.status.message.find(ros::this_node::getName() + " sends it, too"),
            std::string::npos)
      << client.status.message;
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_pose_graph_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
