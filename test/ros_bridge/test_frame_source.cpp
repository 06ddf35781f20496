// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/frame_source.hpp"

#include <gtest/gtest.h>

#include "falko_slam/ros_bridge/pose_conversion.hpp"

namespace falko_slam {
namespace {

void send(tf2::BufferCore& buffer, const char* parent, const char* child, const char* sender) {
  buffer.setTransform(to_transform({}, Time(from_seconds(1.0)), parent, child).transforms[0],
                      sender);
}

TEST(FrameSource, IsWhoHasSentTheFrameLast) {
  tf2::BufferCore buffer;
  EXPECT_FALSE(source_of(buffer, "odom"));
  send(buffer, "map", "odom", "/slam");
  send(buffer, "odom", "base_link", "/wheels");
  ASSERT_TRUE(source_of(buffer, "odom"));
  EXPECT_EQ(source_of(buffer, "odom")->parent, "map");
  EXPECT_EQ(source_of(buffer, "odom")->broadcaster, "/slam");
  EXPECT_EQ(source_of(buffer, "base_link")->broadcaster, "/wheels");
  EXPECT_FALSE(source_of(buffer, "map"));
  EXPECT_FALSE(source_of(buffer, "link"));
}

}  // namespace
}  // namespace falko_slam
