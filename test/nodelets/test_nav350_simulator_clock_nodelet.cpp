// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tf2_ros/transform_listener.h>

#include "simulator_client.hpp"

namespace falko_slam {
namespace {

using test::SimulatorClient;
using test::spin_until;

TEST(SimulatorAsClock, TimeGoesAsFastAsItIsTold) {
  SimulatorClient client("/");
  ASSERT_TRUE(spin_until([&] { return !ros::Time::now().isZero() && !client.scans.empty(); }));
  const ros::SteadyTime wall = ros::SteadyTime::now();
  const ros::Time begin = ros::Time::now();
  test::spin_for(2.0 * test::patience());
  const double simulated = (ros::Time::now() - begin).toSec();
  const double real = (ros::SteadyTime::now() - wall).toSec();
  EXPECT_LT(simulated / real, 10.0);
  EXPECT_GT(simulated / real, 6.0 / test::patience());  // it may be too slow for 8
}

TEST(SimulatorAsClock, StampsAreOfItsTimeAndWithoutJitter) {
  SimulatorClient client("/");
  ASSERT_TRUE(spin_until([&] { return client.scans.size() > 30; }));
  for (std::size_t i = 1; i < client.scans.size(); ++i) {
    const ros::Duration step = client.scans[i].header.stamp - client.scans[i - 1].header.stamp;
    EXPECT_EQ(step.toNSec(), 125000000) << i;
  }
  EXPECT_LE(client.scans.back().header.stamp, ros::Time::now());
}

TEST(SimulatorAsClock, ConnectsTheWorldWithTheOdometryIfAsked) {
  SimulatorClient client("/");
  tf2_ros::Buffer buffer;
  tf2_ros::TransformListener listener(buffer, client.node);
  EXPECT_TRUE(spin_until([&] { return buffer.canTransform("world", "laser", ros::Time(0)); }));
}

}  // namespace
}  // namespace falko_slam

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_nav350_simulator_clock_nodelet");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
