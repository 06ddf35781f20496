// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"
#include "simulator_client.hpp"

namespace falko_slam {
namespace {

using test::SimulatorClient;
using test::spin_until;

double speed_of(const SimulatorClient& client) {
  return client.odometry.back().twist.twist.linear.x;
}

class Commanded : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(spin_until([this] { return client_.leads() && client_.scans.size() > 2; }));
  }
  bool reset() {
    std_srvs::Trigger call;
    return ros::service::call("/commanded/nav350_simulator/reset", call) && call.response.success;
  }

  SimulatorClient client_{"commanded"};
};

TEST_F(Commanded, ScansAreThoseOfTheSickDriver) {
  const sensor_msgs::LaserScan& scan = client_.scans.back();

  EXPECT_EQ(scan.header.frame_id, "cloud");
  EXPECT_NEAR(scan.angle_min, -kPi, 1e-6);
  EXPECT_NEAR(scan.angle_max, kPi, 1e-6);
  EXPECT_NEAR(scan.angle_increment, degrees_to_radians(0.25), 1e-8);
  EXPECT_NEAR(scan.scan_time, 0.125, 1e-9);
  EXPECT_NEAR(scan.time_increment, 8.68e-5, 1e-7);
  EXPECT_NEAR(scan.range_min, 0.05, 1e-7);
  EXPECT_NEAR(scan.range_max, 100.0, 1e-5);
  EXPECT_EQ(scan.ranges.size(), 1440U);
  EXPECT_EQ(scan.intensities.size(), 1440U);
}

TEST_F(Commanded, ScansComeEveryEighthOfASecondAndNotBeforeTheyAreMeasured) {
  client_.scans.clear();
  double latest = 0.0;
  std::size_t seen = 0;
  spin_until([&] {
    for (; seen < client_.scans.size(); ++seen) {
      const double age = (ros::Time::now() - client_.scans[seen].header.stamp).toSec();
      EXPECT_GT(age, 0.12);
      latest = std::max(latest, age);
    }
    return seen > 20;
  });
  ASSERT_GT(client_.scans.size(), 20U);
  for (std::size_t i = 1; i < client_.scans.size(); ++i) {
    const double step = (client_.scans[i].header.stamp - client_.scans[i - 1].header.stamp).toSec();
    EXPECT_NEAR(step, 0.125, 0.001);
  }
  EXPECT_LT(latest, 1.0);
}

TEST_F(Commanded, DrivesAsItIsLedAndHaltsWhenNobodyLeads) {
  ASSERT_TRUE(reset());
  client_.encoders.clear();
  client_.lead(0.5, 0.3, 2.0);
  EXPECT_GT(speed_of(client_), 0.3);
  EXPECT_GT(client_.encoders.back().drive_ticks - client_.encoders.front().drive_ticks, 500U);
  EXPECT_NEAR(client_.joints.back().position.at(0), 0.3, 0.02);
  EXPECT_TRUE(spin_until([this] { return speed_of(client_) == 0.0; }, 5.0));
}

TEST_F(Commanded, RefusesCommandsThatAreNotFinite) {
  client_.lead(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.5);
  test::spin_for(1.0);
  EXPECT_EQ(speed_of(client_), 0.0);
  client_.lead(-0.4, 0.0, 1.5);
  EXPECT_LT(speed_of(client_), -0.2);
}

TEST_F(Commanded, ResetPutsItBackAtItsStart) {
  ASSERT_TRUE(spin_until([this] { return !client_.truth.empty(); }));
  ASSERT_TRUE(reset());
  client_.truth.clear();
  ASSERT_TRUE(spin_until([this] { return client_.truth.size() > 5; }));
  const geometry_msgs::Point start = client_.truth.back().pose.position;
  client_.lead(0.8, 0.0, 2.0);
  const geometry_msgs::Point there = client_.truth.back().pose.position;
  EXPECT_GT(std::hypot(there.x - start.x, there.y - start.y), 0.5);
  ASSERT_TRUE(reset());
  client_.truth.clear();
  ASSERT_TRUE(spin_until([this] { return client_.truth.size() > 5; }));
  const geometry_msgs::Point back = client_.truth.back().pose.position;
  EXPECT_NEAR(back.x, start.x, 1e-9);
  EXPECT_NEAR(back.y, start.y, 1e-9);
}

TEST_F(Commanded, TellsReflectorsWithoutTheirNumbers) {
  ASSERT_TRUE(spin_until([this] { return !client_.reflectors.empty(); }));
  ASSERT_GE(client_.reflectors.back().reflectors.size(), 6U);
  for (const Reflector& reflector : client_.reflectors.back().reflectors) {
    EXPECT_EQ(reflector.global_id, Reflector::UNKNOWN_ID);
    EXPECT_NEAR(std::hypot(reflector.position.x, reflector.position.y), reflector.range, 1e-9);
  }
}

TEST_F(Commanded, SendsItsTransforms) {
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer, client_.node);
  EXPECT_TRUE(
      spin_until([&] { return buffer.canTransform("commanded_odom", "cloud", ros::Time(0)); }));
}

TEST(Scripted, DrivesOnItsOwn) {
  SimulatorClient client("scripted");
  ASSERT_TRUE(spin_until([&] { return !client.truth.empty(); }));
  const geometry_msgs::Point start = client.truth.front().pose.position;
  EXPECT_TRUE(spin_until(
      [&] {
        const geometry_msgs::Point& here = client.truth.back().pose.position;
        return std::hypot(here.x - start.x, here.y - start.y) > 1.0;
      },
      20.0));
  EXPECT_FALSE(client.leads());
}

TEST(Scripted, ShowsItsWorld) {
  SimulatorClient client("scripted");
  visualization_msgs::MarkerArray world;
  const ros::Subscriber markers = client.node.subscribe<visualization_msgs::MarkerArray>(
      "world_markers", 1,
      [&](const visualization_msgs::MarkerArrayConstPtr& message) { world = *message; });
  EXPECT_TRUE(spin_until([&] { return !world.markers.empty(); }));
}

TEST(SimulatorParameters, BadOnesKeepTheNodeletFromLoading) {
  nodelet::Loader loader(false);
  ros::NodeHandle node("/refused");
  EXPECT_FALSE(loader.load("/refused", "falko_slam/Nav350Simulator", {}, {}));
  node.setParam("scenario", "/there/is/no/such.yaml");
  EXPECT_FALSE(loader.load("/refused", "falko_slam/Nav350Simulator", {}, {}));
  node.setParam("scenario", FALKO_SLAM_SOURCE_DIR "/config/scenarios/office_loop.yaml");
  node.setParam("rate", 2.0);  // needs use_sim_time
  EXPECT_FALSE(loader.load("/refused", "falko_slam/Nav350Simulator", {}, {}));
  node.setParam("rate", 1.0);
  node.setParam("publish_tf", false);
  EXPECT_TRUE(loader.load("/refused", "falko_slam/Nav350Simulator", {}, {}));
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_nav350_simulator_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
