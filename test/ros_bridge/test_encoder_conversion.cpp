// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/encoder_conversion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max();

JointParams joint_params() {
  JointParams params;
  params.encoders.steer_ticks_per_turn = 8192;
  params.encoders.steer_zero = 100;
  params.encoders.steer_gain = 0.1;
  params.drive_ticks_per_turn = 5000;
  return params;
}

EncoderReading reading_of(std::uint32_t drive_ticks, std::uint32_t steer_ticks) {
  return {Time(std::chrono::nanoseconds(1668091584821040869)), drive_ticks, steer_ticks};
}

void expect_same(const EncoderReading& reading, const EncoderReading& expected) {
  EXPECT_EQ(reading.stamp, expected.stamp);
  EXPECT_EQ(reading.drive_ticks, expected.drive_ticks);
  EXPECT_EQ(reading.steer_ticks, expected.steer_ticks);
}

sensor_msgs::JointState message_of(const std::vector<std::string>& names,
                                   const std::vector<double>& positions) {
  sensor_msgs::JointState message;
  message.name = names;
  message.position = positions;
  return message;
}

TEST(EncoderConversion, CountersStayAsTheyAre) {
  const EncoderReading reading = reading_of(kLast, 8191);
  const TricycleEncoders message = to_message(reading, "base_link");
  EXPECT_EQ(message.header.frame_id, "base_link");
  EXPECT_EQ(message.header.stamp, ros::Time(1668091584, 821040869));
  EXPECT_EQ(message.drive_ticks, kLast);
  EXPECT_EQ(message.steer_ticks, 8191U);
  expect_same(from_message(message), reading);
}

TEST(EncoderConversion, JointsAreAnglesInRadians) {
  JointStateSource joints(joint_params());
  const sensor_msgs::JointState message = joints.next(reading_of(12500, 100 + 2048));
  EXPECT_EQ(message.name, (std::vector<std::string>{"steer_joint", "drive_joint"}));
  ASSERT_EQ(message.position.size(), 2U);
  EXPECT_NEAR(message.position[0], 0.1 * kPi / 2.0, 1e-15);
  EXPECT_NEAR(message.position[1], 2.5 * kTwoPi, 1e-12);
  EXPECT_TRUE(message.velocity.empty());
  EXPECT_TRUE(message.effort.empty());
  EXPECT_EQ(message.header.stamp, ros::Time(1668091584, 821040869));
}

TEST(EncoderConversion, TheDriveJointGoesOnOverTheEndOfTheCounter) {
  JointStateSource joints(joint_params());
  const double start = joints.next(reading_of(kLast - 1, 0)).position[1];
  const double over = joints.next(reading_of(1, 0)).position[1];
  const double back = joints.next(reading_of(kLast - 2, 0)).position[1];
  EXPECT_NEAR(over - start, 3.0 * kTwoPi / 5000.0, 1e-9);
  EXPECT_NEAR(back - start, -1.0 * kTwoPi / 5000.0, 1e-9);
}

TEST(EncoderConversion, JointsComeBackAsTheirCounters) {
  auto random = test::seeded_random();
  std::uniform_int_distribution<std::uint32_t> steering(0, 8191);
  std::uniform_int_distribution<std::uint32_t> ticks(0, 1U << 30U);
  JointStateSource joints(joint_params());
  EncoderReading reading = reading_of(kLast, 0);
  for (int i = 0; i < 1000; ++i) {  // many times over the counter's end
    reading.drive_ticks += ticks(random);
    reading.steer_ticks = steering(random);
    const auto back = from_message(joints.next(reading), joint_params());
    ASSERT_TRUE(back);
    expect_same(*back, reading);
  }
}

TEST(EncoderConversion, AWheelThatTurnedBackwardsCountsDownFromTheEnd) {
  const auto reading =
      from_message(message_of({"drive_joint", "steer_joint"}, {-kTwoPi, 0.0}), joint_params());
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->drive_ticks, kLast - 4999);
  EXPECT_EQ(reading->steer_ticks, 100U);
}

TEST(EncoderConversion, FindsTheJointsAmongOthers) {
  const auto reading =
      from_message(message_of({"lift", "drive_joint", "steer_joint"}, {9.0, kTwoPi, 0.01 * kPi}),
                   joint_params());
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->drive_ticks, 5000U);
  EXPECT_EQ(reading->steer_ticks, 100U + 410U);  // a twentieth of a turn
}

TEST(EncoderConversion, WhatIsNoReadingIsNone) {
  const JointParams params = joint_params();
  const double nan = std::nan("");
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<std::string> both = {"steer_joint", "drive_joint"};
  EXPECT_FALSE(from_message(message_of({}, {}), params));
  EXPECT_FALSE(from_message(message_of({"steer_joint"}, {0.0}), params));
  EXPECT_FALSE(from_message(message_of({"drive_joint"}, {0.0}), params));
  EXPECT_FALSE(from_message(message_of(both, {}), params));
  EXPECT_FALSE(from_message(message_of(both, {0.0}), params));
  EXPECT_FALSE(from_message(message_of(both, {nan, 0.0}), params));
  EXPECT_FALSE(from_message(message_of(both, {0.0, nan}), params));
  EXPECT_FALSE(from_message(message_of(both, {0.0, infinite}), params));
  EXPECT_FALSE(from_message(message_of(both, {1e300, 0.0}), params));
  EXPECT_FALSE(from_message(message_of(both, {0.0, -1e300}), params));
  EXPECT_TRUE(from_message(message_of(both, {0.0, 0.0}), params));
}

TEST(EncoderConversion, RefusesParametersByName) {
  JointParams params = joint_params();
  params.drive_ticks_per_turn = 0;
  EXPECT_THROW(JointStateSource joints(params), std::invalid_argument);
  params = joint_params();
  params.encoders.steer_gain = 2.5;
  EXPECT_THROW(JointStateSource joints(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
