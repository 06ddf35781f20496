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
#include "slam_client.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::LoadedSlam;
using test::pose_of;
using test::SlamClient;
using test::spin_until;
constexpr int kOk = diagnostic_msgs::DiagnosticStatus::OK;
constexpr int kWarn = diagnostic_msgs::DiagnosticStatus::WARN;

constexpr double kStep = 0.25;
const Pose2 kStart{20.0, -7.0, 1.0};  // where the odometry has the office's frame

/// Round the office, with an odometry that drifts.
class Way {
 public:
  explicit Way(const Pose2& odom_T_world = kStart, std::size_t first = 0)
      : lap_(office_path(kStep)), first_(first), odometry_(odom_T_world * truth(0)) {}

  Pose2 truth(std::size_t i) const { return lap_[(first_ + i) % lap_.size()]; }
  std::size_t lap() const { return lap_.size(); }
  std::size_t driven() const { return driven_; }
  const Pose2& odometry() const { return odometry_; }
  void drive(SlamClient& client, std::size_t steps) {
    for (std::size_t i = 0; i < steps; ++i, ++driven_) {
      if (driven_ > 0) {
        const Pose2 step = truth(driven_ - 1).inverse() * truth(driven_);
        odometry_ = odometry_ * Pose2(1.01 * step.translation(), step.theta() + 0.001);
      }
      client.step(truth(driven_), odometry_);
    }
  }
  Pose2 here() const { return truth(driven_ - 1); }

 private:
  std::vector<Pose2> lap_;
  std::size_t first_;
  std::size_t driven_ = 0;
  Pose2 odometry_;
};

bool all_came(SlamClient& client) {
  return spin_until(
      [&] { return !client.poses.empty() && client.last_pose().header.stamp == client.stamp; });
}
double error_of(const SlamClient& client, const Pose2& expected) {
  return (expected.inverse() * pose_of(client.last_pose().pose.pose)).translation().norm();
}
void expect_stamps_rise(const std::vector<geometry_msgs::TransformStamped>& transforms) {
  for (std::size_t i = 1; i < transforms.size(); ++i) {
    EXPECT_LT(transforms[i - 1].header.stamp, transforms[i].header.stamp) << i;
  }
}

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
    spin_until([] { return false; }, 0.002);
  }
  EXPECT_NEAR((client.to_map.back().header.stamp - last).toSec(), 3.1, 0.3);
  EXPECT_TRUE(client.diagnosed("no scan on /silence/scan for 1", kWarn)) << client.status.message;
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
  spin_until([] { return false; }, 0.1);
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
    spin_until([] { return false; }, 0.004);
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
  ASSERT_TRUE(spin_until([&] { return client.map != nullptr; }));
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
