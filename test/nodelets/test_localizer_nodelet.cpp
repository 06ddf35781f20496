// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A simulated vehicle drives through the warehouse on a map of its reflectors.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <falko_slam/LandmarkArray.h>
#include <falko_slam/LocalizerStatus.h>
#include <falko_slam/SetPose.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <map>
#include <optional>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/pose_file.hpp"
#include "falko_slam/ros_bridge/file_folder.hpp"
#include "falko_slam/ros_bridge/localizer_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "simulated_drive_client.hpp"

namespace falko_slam {
namespace {

using test::SimulatedDriveClient;
using test::spin_until;

constexpr char kScenario[] = FALKO_SLAM_SOURCE_DIR "/config/scenarios/warehouse.yaml";

// Hears what the localizer publishes.
class LocalizerClient {
 public:
  LocalizerClient() {
    keep("status", status);
    keep("odometry", odometry);
    keep("landmarks", landmarks);
    keep("diagnostics", diagnostics);
    transforms_ = node.subscribe<tf2_msgs::TFMessage>(
        "/tf", 1000, [this](const tf2_msgs::TFMessageConstPtr& message) {
          for (const auto& transform : message->transforms) {
            if (transform.child_frame_id == "odom") map_T_odom.push_back(transform);
            if (transform.child_frame_id == "base_link") odom_T_base = transform;
          }
        });
  }

  bool is(std::uint8_t level) const { return status && status->level == level; }

  ros::NodeHandle node;
  std::optional<LocalizerStatus> status;
  std::optional<nav_msgs::Odometry> odometry;
  std::optional<LandmarkArray> landmarks;
  std::optional<diagnostic_msgs::DiagnosticArray> diagnostics;
  std::vector<geometry_msgs::TransformStamped> map_T_odom;
  geometry_msgs::TransformStamped odom_T_base;

 private:
  template <class Message>
  void keep(const std::string& topic, std::optional<Message>& last) {
    const std::string name = topic == "diagnostics" ? "/diagnostics" : topic;
    subscribers_.push_back(node.subscribe<Message>(
        name, 100, [&last](const boost::shared_ptr<const Message>& message) { last = *message; }));
  }

  ros::Subscriber transforms_;
  std::vector<ros::Subscriber> subscribers_;
};

// One vehicle for all tests, which go on where the one before ended.
class LocalizerNode : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    drive_ = new SimulatedDriveClient(kScenario, Time(std::chrono::seconds(1000)));
    client_ = new LocalizerClient();
    ASSERT_TRUE(spin_until([] { return drive_->is_heard(); }, 30.0));
    drive_->pass(0.5);
  }
  static void TearDownTestSuite() {
    delete client_;
    delete drive_;
  }

  static bool becomes(std::uint8_t level, double seconds) {
    return drive_->pass_until([level] { return client_->is(level); }, seconds);
  }
  static geometry_msgs::PoseWithCovarianceStamped said(const Pose2& pose, double position,
                                                       double heading) {
    return pose_message({pose, pose_covariance(position, heading)}, drive_->now(), "map");
  }
  static SetPose::Response set(const geometry_msgs::PoseWithCovarianceStamped& pose) {
    SetPose service;
    service.request.pose = pose;
    EXPECT_TRUE(ros::service::call("localizer/set_pose", service));
    return service.response;
  }
  static void make_ok() {
    if (client_->is(LocalizerStatus::OK)) return;
    ASSERT_TRUE(set(said(drive_->truth(), 0.1, 0.05)).success);
    ASSERT_TRUE(becomes(LocalizerStatus::OK, 10.0)) << client_->status->text;
  }
  static void expect_at_truth(double distance, double turn) {
    const Pose2 error = drive_->truth().inverse() * in_plane(client_->odometry->pose.pose);
    EXPECT_LT(error.translation().norm(), distance);
    EXPECT_LT(std::abs(error.theta()), turn);
  }

  static SimulatedDriveClient* drive_;
  static LocalizerClient* client_;
};
SimulatedDriveClient* LocalizerNode::drive_ = nullptr;
LocalizerClient* LocalizerNode::client_ = nullptr;

TEST_F(LocalizerNode, IsOkSoonAfterAnInitialPoseThatIsOff) {
  ros::Publisher publisher =
      client_->node.advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1);
  ASSERT_TRUE(spin_until([&] { return publisher.getNumSubscribers() > 0; }));
  publisher.publish(said(drive_->truth() * Pose2(0.15, -0.1, 0.04), 0.2, 0.05));

  EXPECT_TRUE(becomes(LocalizerStatus::OK, 8.0)) << client_->status->text;
  drive_->pass(1.0);
  expect_at_truth(0.03, 0.005);
}

TEST_F(LocalizerNode, StaysAtTheTruthOnTheWay) {
  make_ok();
  for (int i = 0; i < 10; ++i) {
    drive_->pass(1.0);
    EXPECT_TRUE(client_->is(LocalizerStatus::OK)) << client_->status->text;
    expect_at_truth(0.06, 0.01);
  }
  ASSERT_TRUE(client_->landmarks);
  std::map<int, int> by_source;
  for (const auto& landmark : client_->landmarks->landmarks) ++by_source[landmark.source];
  EXPECT_GE(by_source[LandmarkEstimate::MAP], 2);
  EXPECT_GT(by_source[LandmarkEstimate::STATE], 0);
  EXPECT_EQ(client_->landmarks->header.frame_id, "map");
  EXPECT_GT(client_->status->along_deviation, 0.0);
}

TEST_F(LocalizerNode, SendsTheMapToTfWithStampsThatGrow) {
  make_ok();
  client_->map_T_odom.clear();
  drive_->pass(3.0);

  ASSERT_GT(client_->map_T_odom.size(), 20U);
  for (std::size_t i = 1; i < client_->map_T_odom.size(); ++i) {
    EXPECT_LT(client_->map_T_odom[i - 1].header.stamp, client_->map_T_odom[i].header.stamp);
  }
  const Pose2 map_T_base =
      in_plane(client_->map_T_odom.back().transform) * in_plane(client_->odom_T_base.transform);
  EXPECT_LT((drive_->truth().inverse() * map_T_base).translation().norm(), 0.08);
}

TEST_F(LocalizerNode, WritesThePoseDown) {
  make_ok();
  drive_->pass(2.0);
  const SavedPose saved = read_saved_pose(default_file_folder() + "/test_localizer/pose.yaml");
  EXPECT_LT((drive_->truth().inverse() * saved.map_T_base.pose).translation().norm(), 2.0);
  EXPECT_EQ(saved.map.find("28 landmarks, "), 0U) << saved.map;
}

TEST_F(LocalizerNode, RefusesPosesThatAreNone) {
  make_ok();
  auto pose = said(drive_->truth(), 0.1, 0.05);
  pose.header.frame_id = "odom";
  EXPECT_EQ(set(pose).message, "it is in the frame odom, not map");
  pose = said(drive_->truth(), 0.1, 0.05);
  pose.pose.pose.orientation.w += 0.5;
  EXPECT_EQ(set(pose).message, "its orientation is not a quaternion of length 1");
  pose = said(drive_->truth(), 0.1, 0.05);
  pose.pose.covariance[0] = -1.0;
  EXPECT_EQ(set(pose).message, "its covariance is not symmetric and positive semidefinite");
  pose = said(drive_->truth(), 0.1, 0.05);
  pose.header.stamp -= ros::Duration(30.0);
  EXPECT_EQ(set(pose).success, 0);
  EXPECT_TRUE(client_->is(LocalizerStatus::OK));
}

TEST_F(LocalizerNode, SetPoseMovesThePose) {
  make_ok();
  const auto response = set(said(drive_->truth() * Pose2(0.1, 0.0, 0.0), 0.2, 0.05));
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_TRUE(spin_until([] { return client_->is(LocalizerStatus::DEGRADED); }));
  EXPECT_EQ(client_->status->reason, LocalizerStatus::UNCONFIRMED);
  EXPECT_TRUE(becomes(LocalizerStatus::OK, 8.0)) << client_->status->text;
}

TEST_F(LocalizerNode, FindsItselfWhenAsked) {
  make_ok();
  std_srvs::Trigger service;
  ASSERT_TRUE(ros::service::call("localizer/global_localization", service));
  EXPECT_TRUE(service.response.success);
  EXPECT_TRUE(spin_until([] { return client_->is(LocalizerStatus::RECOVERING); }))
      << client_->status->text;

  EXPECT_TRUE(becomes(LocalizerStatus::OK, 60.0)) << client_->status->text;
  expect_at_truth(0.06, 0.01);
}

TEST_F(LocalizerNode, IsDegradedWithoutScansAndRecovers) {
  make_ok();
  drive_->sends_scans = false;
  EXPECT_TRUE(becomes(LocalizerStatus::DEGRADED, 3.0));
  EXPECT_EQ(client_->status->reason, LocalizerStatus::NO_SCANS);
  client_->map_T_odom.clear();
  drive_->pass(1.0);
  EXPECT_FALSE(client_->map_T_odom.empty());
  drive_->sends_scans = true;
  EXPECT_TRUE(becomes(LocalizerStatus::OK, 10.0)) << client_->status->text;
}

TEST_F(LocalizerNode, IsLostWithoutAnythingAndSaysNothingToTf) {
  make_ok();
  drive_->sends_scans = drive_->sends_encoders = false;
  const bool lost = drive_->pass_until(
      [] { return client_->is(LocalizerStatus::LOST) || client_->is(LocalizerStatus::RECOVERING); },
      20.0);
  EXPECT_TRUE(lost) << client_->status->text;
  drive_->pass(0.5);
  client_->map_T_odom.clear();
  drive_->pass(1.0);
  EXPECT_TRUE(client_->map_T_odom.empty());
  EXPECT_LT(client_->status->along_deviation, 0.0);
  drive_->sends_scans = drive_->sends_encoders = true;
}

TEST_F(LocalizerNode, GoesOnAfterTheClockWasSetBack) {
  make_ok();
  drive_->begin(Time(std::chrono::seconds(500)));
  drive_->pass(1.0);
  ASSERT_TRUE(set(said(drive_->truth(), 0.1, 0.05)).success);
  client_->map_T_odom.clear();
  EXPECT_TRUE(becomes(LocalizerStatus::OK, 10.0)) << client_->status->text;
  drive_->pass(2.0);
  expect_at_truth(0.05, 0.01);
  ASSERT_FALSE(client_->map_T_odom.empty());
  EXPECT_LT(client_->map_T_odom.back().header.stamp.toSec(), 600.0);
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_localizer_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
