// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <limits>

#include "detector_client.hpp"
#include "falko_slam/features/feature_extractor.hpp"
#include "falko_slam/ros_bridge/laser_mount.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"

namespace falko_slam {
namespace {

using sensor_msgs::LaserScan;
using test::DetectorClient;
using test::office_scan;
using test::spin_until;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class KeypointDetectorNodelet : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { ASSERT_TRUE(detector_.connected()); }

  // It has answered `scan` without keypoints and is still there for the next.
  void expect_survival(const LaserScan& scan) {
    const auto answer = detector_.ask(scan);
    ASSERT_TRUE(answer);
    EXPECT_TRUE(answer->features.empty());
    const auto next = detector_.ask(office_scan(360));
    ASSERT_TRUE(next);
    EXPECT_FALSE(next->features.empty());
  }

  DetectorClient detector_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Ways, KeypointDetectorNodelet, ::testing::Values("as_nodelet", "as_node"),
                         [](const auto& way) { return std::string(way.param); });

TEST_P(KeypointDetectorNodelet, PublishesWhatTheCoreFinds) {
  const LaserScan scan = office_scan(1440);
  FeatureExtractor extractor;
  extractor.extract(as_raw_scan(scan));

  const auto answer = detector_.ask(scan);

  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->header.frame_id, "laser");
  ASSERT_EQ(answer->features.size(), extractor.features().size());
  ASSERT_FALSE(answer->features.empty());
  for (std::size_t i = 0; i < answer->features.size(); ++i) {
    const Keypoint& expected = extractor.features()[i].keypoint;
    EXPECT_EQ(answer->features[i].position.x, expected.position.x());
    EXPECT_EQ(answer->features[i].position.y, expected.position.y());
    EXPECT_LT(answer->features[i].index, 1440U);
    EXPECT_EQ(answer->features[i].bsc.size(), 8U * 16U / 8U);
    EXPECT_EQ(answer->features[i].cgh.size(), 16U);
  }
}

TEST_P(KeypointDetectorNodelet, SurvivesAScanWithoutBeams) {
  LaserScan scan = office_scan(360);
  scan.ranges.clear();
  expect_survival(scan);
}

TEST_P(KeypointDetectorNodelet, SurvivesAScanOfOneBeam) {
  LaserScan scan = office_scan(360);
  scan.ranges.resize(1);
  expect_survival(scan);
}

TEST_P(KeypointDetectorNodelet, SurvivesAScanOfNaN) {
  LaserScan scan = office_scan(360);
  std::fill(scan.ranges.begin(), scan.ranges.end(), kNaN);
  expect_survival(scan);
}

TEST_P(KeypointDetectorNodelet, SurvivesAnglesWithoutSense) {
  LaserScan scan = office_scan(360);
  scan.angle_min = kNaN;
  expect_survival(scan);
  scan = office_scan(360);
  scan.angle_increment = 0.0F;
  scan.angle_max = scan.angle_min;
  expect_survival(scan);
}

TEST_P(KeypointDetectorNodelet, ReadsAScanThatRunsClockwise) {
  const LaserScan scan = office_scan(720);
  LaserScan clockwise = scan;
  std::reverse(clockwise.ranges.begin(), clockwise.ranges.end());
  clockwise.angle_increment = -scan.angle_increment;
  clockwise.angle_min = scan.angle_min + 719.0F * scan.angle_increment;
  clockwise.angle_max = scan.angle_min - scan.angle_increment;

  const auto answer = detector_.ask(scan);
  const auto mirrored = detector_.ask(clockwise);

  ASSERT_TRUE(answer && mirrored);
  ASSERT_EQ(answer->features.size(), mirrored->features.size());
  for (const auto& feature : answer->features) {
    const auto same = [&](const Feature& other) {
      return std::hypot(other.position.x - feature.position.x,
                        other.position.y - feature.position.y) < 1e-3;
    };
    EXPECT_TRUE(std::any_of(mirrored->features.begin(), mirrored->features.end(), same));
  }
}

TEST_P(KeypointDetectorNodelet, AnswersAHundredThousandBeams) {
  const auto answer = detector_.ask(office_scan(100000));
  ASSERT_TRUE(answer);
  EXPECT_GT(answer->features.size(), 5U);
}

TEST_P(KeypointDetectorNodelet, GoesOnWhenStampsRunBackward) {
  ASSERT_TRUE(detector_.ask_at(ros::Time(5000.0), office_scan(360)));
  const auto answer = detector_.ask_at(ros::Time(10.0), office_scan(360));
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->features.empty());
}

TEST_P(KeypointDetectorNodelet, DrawsListsForWhoSubscribes) {
  visualization_msgs::MarkerArrayConstPtr markers;
  sensor_msgs::PointCloud2ConstPtr cloud;
  ros::NodeHandle& node = detector_.node();
  const auto marker_subscriber = node.subscribe<visualization_msgs::MarkerArray>(
      "feature_markers", 1, [&](const auto& message) { markers = message; });
  const auto cloud_subscriber = node.subscribe<sensor_msgs::PointCloud2>(
      "keypoint_cloud", 1, [&](const auto& message) { cloud = message; });

  std::optional<FeatureArray> answer;
  ASSERT_TRUE(spin_until([&] {
    answer = detector_.ask(office_scan(360));
    return markers && cloud;
  }));

  using visualization_msgs::Marker;
  ASSERT_EQ(markers->markers.size(), 2U);
  EXPECT_EQ(markers->markers[0].type, Marker::SPHERE_LIST);
  EXPECT_EQ(markers->markers[1].type, Marker::LINE_LIST);
  EXPECT_EQ(markers->markers[0].points.size(), answer->features.size());
  EXPECT_EQ(cloud->width * cloud->height, answer->features.size());
  EXPECT_EQ(cloud->header.frame_id, "laser");
}

TEST_P(KeypointDetectorNodelet, TakesGoodParametersAndRefusesBadOnes) {
  const std::string service =
      detector_.node().resolveName("keypoint_detector/falko/set_parameters");
  const auto set = [&](const std::string& name, double value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.doubles.resize(1);
    call.request.config.doubles[0].name = name;
    call.request.config.doubles[0].value = value;
    EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(10.0 * test::patience())));
    EXPECT_TRUE(ros::service::call(service, call));
    for (const auto& entry : call.response.config.doubles) {
      if (entry.name == name) return entry.value;
    }
    return -1.0;
  };
  const std::size_t before = detector_.ask(office_scan(360))->features.size();

  EXPECT_EQ(set("suppression_radius", 3.0), 3.0);
  const auto fewer = detector_.ask(office_scan(360));
  EXPECT_EQ(set("merge_radius", 2.0), 0.1);  // at most half the suppression radius
  EXPECT_EQ(set("suppression_radius", 0.2), 0.2);
  const auto again = detector_.ask(office_scan(360));

  ASSERT_TRUE(fewer && again);
  EXPECT_LT(fewer->features.size(), before);
  EXPECT_EQ(again->features.size(), before);
}

TEST_P(KeypointDetectorNodelet, TellsOfUnusableScansInDiagnostics) {
  diagnostic_msgs::DiagnosticStatus status;
  const std::string name =
      detector_.node().resolveName("keypoint_detector").substr(1) + ": keypoint detection";
  ros::NodeHandle root;
  const auto subscriber = root.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&](const diagnostic_msgs::DiagnosticArrayConstPtr& message) {
        for (const auto& entry : message->status) {
          if (entry.name == name) status = entry;
        }
      });
  using diagnostic_msgs::DiagnosticStatus;
  LaserScan empty = office_scan(360);
  empty.ranges.clear();

  EXPECT_TRUE(spin_until([&] {
    return detector_.ask(office_scan(360)) && status.level == DiagnosticStatus::OK &&
           status.message.find("scans/s") != std::string::npos;
  })) << status.message;
  EXPECT_TRUE(
      spin_until([&] { return detector_.ask(empty) && status.level == DiagnosticStatus::ERROR; }));
  EXPECT_NE(status.message.find("unusable scan"), std::string::npos) << status.message;
}

TEST(KeypointDetectorOnCeiling, LearnsFromTfThatItHangsUpsideDown) {
  DetectorClient detector("on_ceiling");
  ASSERT_TRUE(detector.connected());
  tf2_ros::StaticTransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped mount;
  mount.header.frame_id = "base_link";
  mount.child_frame_id = "laser";
  mount.transform.rotation.x = 1.0;
  broadcaster.sendTransform(mount);

  EXPECT_TRUE(spin_until([&] {
    const auto answer = detector.ask(office_scan(360));
    return answer && answer->upside_down;
  }));
  LaserMount mounts("base_link");
  EXPECT_TRUE(spin_until([&] { return mounts.upside_down("laser").value_or(false); }));
  EXPECT_FALSE(mounts.upside_down("laser_that_nobody_has"));
}

TEST(KeypointDetectorParameters, BadOnesKeepTheNodeletFromLoading) {
  nodelet::Loader loader(false);
  ros::NodeHandle node("/refused");
  node.setParam("falko/sectors", "many");
  EXPECT_FALSE(loader.load("/refused", "falko_slam/KeypointDetector", {}, {}));
  node.setParam("falko/sectors", 16);
  EXPECT_TRUE(loader.load("/refused", "falko_slam/KeypointDetector", {}, {}));
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_keypoint_detector_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
