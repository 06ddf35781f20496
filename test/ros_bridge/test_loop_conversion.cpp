// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_conversion.hpp"

#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "support/loop_memory.hpp"

namespace falko_slam {
namespace {

TEST(LoopConversion, TellsAllOfAKeyframe) {
  const KeyframeMemory memory = test::room_memory();
  const KeyframeArray message = to_message(memory, {1}, "odom");

  EXPECT_FALSE(message.reset);
  EXPECT_EQ(message.header.frame_id, "odom");
  EXPECT_EQ(message.header.stamp, ros::Time(102));
  ASSERT_EQ(message.keyframes.size(), 2U);
  const KeyframeScan& keyframe = message.keyframes[1];
  EXPECT_EQ(keyframe.id, 2U);
  EXPECT_EQ(keyframe.drive, 1U);
  EXPECT_EQ(keyframe.header.stamp, ros::Time(102));
  EXPECT_EQ(keyframe.header.frame_id, "odom");
  EXPECT_EQ(keyframe.odom_T_keyframe, to_message(memory.record({2}).odom_T_laser));
  EXPECT_EQ(keyframe.base_T_keyframe, to_message(Pose2(0.5, 0.0, 0.1)));
  EXPECT_EQ(keyframe.path, 0.0);
  EXPECT_EQ(keyframe.keypoints, memory.keyframe({2}).points.size());
  EXPECT_EQ(keyframe.scan.ranges.size(), 360U);
  EXPECT_NEAR(message.keyframes[0].path, 0.3, 0.05);
}

TEST(LoopConversion, BeginsAnewWithTheFirstKeyframe) {
  const KeyframeMemory memory = test::room_memory();
  EXPECT_TRUE(to_message(memory, {0}, "odom").reset);
  EXPECT_EQ(to_message(memory, {0}, "odom").keyframes.size(), 3U);
}

TEST(LoopConversion, TellsWhatBecameOfEveryCandidateThatWasMatched) {
  const LoopConstraintArray message =
      to_message(test::room_memory(), {2}, test::room_loop(), "odom");

  EXPECT_EQ(message.source, 2U);
  EXPECT_EQ(message.header.stamp, ros::Time(102));
  ASSERT_EQ(message.constraints.size(), 2U);
  const LoopConstraint& accepted = message.constraints[0];
  EXPECT_TRUE(accepted.accepted);
  EXPECT_EQ(accepted.verdict, LoopConstraint::ACCEPTED);
  EXPECT_EQ(accepted.reason, "accepted");
  EXPECT_EQ(accepted.source, 2U);
  EXPECT_EQ(accepted.target, 0U);
  EXPECT_EQ(accepted.source_stamp, ros::Time(102));
  EXPECT_EQ(accepted.target_stamp, ros::Time(100));
  EXPECT_EQ(accepted.target_T_source.pose, to_message(Pose2(0.6, 0.1, 0.0)));
  EXPECT_EQ(accepted.score, 0.8);
  EXPECT_EQ(accepted.scan_score, 0.9);
  EXPECT_EQ(accepted.pairs, 7U);
  EXPECT_EQ(accepted.signature_distance, 123U);
  EXPECT_EQ(accepted.rms_residual, 0.02);
  EXPECT_FALSE(message.constraints[1].accepted);
  EXPECT_EQ(message.constraints[1].verdict, LoopConstraint::LOW_SCORE);
  EXPECT_EQ(message.constraints[1].reason, "score too low");
}

// The scan is 0.6 m from keyframe 0 along its x axis, the laser 0.5 m ahead of the base.
TEST(LoopConversion, PutsTheBaseWhereTheScanWasTaken) {
  KeyframeMemory memory = test::room_memory();
  LoopDetection detection = test::room_loop();
  detection.candidates.resize(2);
  const Pose2 base_T_laser(0.5, 0.0, 0.1);

  const auto places = to_messages(memory, detection.candidates, base_T_laser, 0);

  ASSERT_EQ(places.size(), 2U);
  const Pose2 expected =
      memory.record({0}).odom_T_laser * Pose2(0.6, 0.1, 0.0) * base_T_laser.inverse();
  EXPECT_NEAR(places[0].pose.pose.position.x, expected.x(), 1e-12);
  EXPECT_NEAR(places[0].pose.pose.position.y, expected.y(), 1e-12);
  EXPECT_NEAR(places[0].pose.pose.orientation.z, std::sin(0.5 * expected.theta()), 1e-12);
  EXPECT_EQ(places[0].keyframe, 0U);
  EXPECT_EQ(places[0].drive, 0U);
  EXPECT_TRUE(places[0].current_drive);
  EXPECT_EQ(places[0].keyframe_stamp, ros::Time(100));
  EXPECT_EQ(places[0].score, 0.8);
  EXPECT_FALSE(to_messages(memory, detection.candidates, base_T_laser, 1)[0].current_drive);
}

}  // namespace
}  // namespace falko_slam
