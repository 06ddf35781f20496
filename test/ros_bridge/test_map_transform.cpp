// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/map_transform.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

const Pose2 kCorrection(1.0, 2.0, 0.5);

MapTransform known_at(double seconds) {
  MapTransform transform({"map", "odom", 0.1, 3.0, {}});
  transform.set(kCorrection, {}, ros::Time(seconds));
  return transform;
}

TEST(MapTransform, SaysNothingBeforeItIsKnownAndBeforeTimeHasBegun) {
  MapTransform transform({"map", "odom", 0.1, 3.0, {}});
  EXPECT_FALSE(transform.at(ros::Time(10.0)));
  transform.set(kCorrection, {}, ros::Time());
  EXPECT_FALSE(transform.at(ros::Time()));
}

TEST(MapTransform, IsStampedAhead) {
  MapTransform transform = known_at(10.0);
  const auto sent = transform.at(ros::Time(10.5));
  ASSERT_TRUE(sent);
  EXPECT_NEAR(sent->header.stamp.toSec(), 10.6, 1e-6);
  EXPECT_EQ(sent->header.frame_id, "map");
  EXPECT_EQ(sent->child_frame_id, "odom");
  EXPECT_DOUBLE_EQ(sent->transform.translation.x, 1.0);
  EXPECT_DOUBLE_EQ(sent->transform.translation.y, 2.0);
}

TEST(MapTransform, NeverRepeatsAStampNorGoesBack) {
  MapTransform transform = known_at(10.0);
  EXPECT_TRUE(transform.at(ros::Time(10.5)));
  EXPECT_FALSE(transform.at(ros::Time(10.5)));
  EXPECT_FALSE(transform.at(ros::Time(10.4)));
  EXPECT_TRUE(transform.at(ros::Time(10.6)));
  transform.reset();
  transform.set(kCorrection, {}, ros::Time(10.0));
  EXPECT_FALSE(transform.at(ros::Time(10.5)));
}

TEST(MapTransform, StopsWithoutNewsAndGoesOnWithThem) {
  MapTransform transform = known_at(10.0);
  EXPECT_TRUE(transform.at(ros::Time(13.0)));
  EXPECT_FALSE(transform.at(ros::Time(13.1)));
  transform.set(kCorrection, {}, ros::Time(14.0));
  EXPECT_TRUE(transform.at(ros::Time(14.1)));
}

TEST(MapTransform, GoesOnWithoutNewsWhileItIsHeld) {
  MapTransform transform = known_at(10.0);
  transform.hold(true);
  EXPECT_TRUE(transform.at(ros::Time(100.0)));
  transform.hold(false);
  EXPECT_FALSE(transform.at(ros::Time(101.0)));
}

TEST(MapTransform, StopsWhenItIsNotKnownAnyMore) {
  MapTransform transform = known_at(10.0);
  transform.reset();
  EXPECT_FALSE(transform.at(ros::Time(10.1)));
}

TEST(MapTransform, BeginsAnewWithTime) {
  MapTransform transform = known_at(1000.0);
  EXPECT_TRUE(transform.at(ros::Time(1000.0)));
  transform.rewind();
  EXPECT_FALSE(transform.at(ros::Time(5.0)));
  transform.set(kCorrection, {}, ros::Time(6.0));
  EXPECT_TRUE(transform.at(ros::Time(6.0)));
}

TEST(MapTransform, LetsTheVehicleFollowSlowly) {
  MapTransformParams params{"map", "odom", 0.1, 3.0, {}};
  params.slew.max_speed = 1.0;
  MapTransform transform(params);
  transform.set({}, {5.0, 0.0, 0.0}, ros::Time(10.0));
  ASSERT_TRUE(transform.at(ros::Time(10.0)));
  transform.set({2.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, ros::Time(10.0));
  EXPECT_NEAR(transform.at(ros::Time(10.5))->transform.translation.x, 0.5, 1e-6);
  EXPECT_NEAR(transform.at(ros::Time(13.0))->transform.translation.x, 2.0, 1e-6);
}

}  // namespace
}  // namespace falko_slam
