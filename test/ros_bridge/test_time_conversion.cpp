// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/time_conversion.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

Time after_epoch(std::int64_t nanoseconds) { return Time(Duration(nanoseconds)); }

TEST(TimeConversion, ThereAndBackIsTheSameNanosecond) {
  for (const ros::Time& time : {ros::Time(0, 0), ros::Time(0, 1), ros::Time(1700000000, 123456789),
                                ros::Time(1, 999999999), ros::TIME_MAX}) {
    EXPECT_EQ(to_ros(from_ros(time)), time) << time;
  }
}

TEST(TimeConversion, CountsFromTheSameEpoch) {
  EXPECT_EQ(from_ros(ros::Time(2, 5)), after_epoch(2'000'000'005));
  EXPECT_EQ(to_ros(after_epoch(2'000'000'005)), ros::Time(2, 5));
}

TEST(TimeConversion, MovesWhatRosCannotHoldToTheNearestEnd) {
  EXPECT_EQ(to_ros(after_epoch(-1)), ros::Time(0, 0));
  EXPECT_EQ(to_ros(Time::min()), ros::Time(0, 0));
  EXPECT_EQ(to_ros(Time::max()), ros::TIME_MAX);
  EXPECT_EQ(to_ros(from_ros(ros::TIME_MAX) + Duration(1)), ros::TIME_MAX);
}

TEST(TimeConversion, DurationsHaveASign) {
  EXPECT_EQ(to_ros(Duration(1'500'000'000)), ros::Duration(1, 500000000));
  EXPECT_EQ(to_ros(Duration(-1)).toNSec(), -1);
  EXPECT_EQ(to_ros(Duration(-2'500'000'001)).toNSec(), -2'500'000'001);
  EXPECT_EQ(to_ros(Duration::zero()), ros::Duration(0, 0));
}

}  // namespace
}  // namespace falko_slam
