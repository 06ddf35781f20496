// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace falko_slam {
namespace {

sensor_msgs::LaserScan message() {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = ros::Time(1700000000, 123456789);
  scan.header.frame_id = "laser";
  scan.angle_min = -3.14159F;
  scan.angle_max = 3.13723F;
  scan.angle_increment = 0.00436332F;
  scan.time_increment = 8.68e-05F;
  scan.scan_time = 0.125F;
  scan.range_min = 0.05F;
  scan.range_max = std::numeric_limits<float>::max();
  scan.ranges = {1.5F, 0.0F, std::numeric_limits<float>::infinity(),
                 std::numeric_limits<float>::denorm_min()};
  scan.intensities = {100.0F, 7.25F};
  return scan;
}

TEST(LaserScanConversion, ThereAndBackIsTheSameMessage) {
  const sensor_msgs::LaserScan there = message();
  const sensor_msgs::LaserScan back = to_message(as_raw_scan(there), "laser");
  EXPECT_EQ(back, there);
}

TEST(LaserScanConversion, KeepsEveryBitOfARange) {
  sensor_msgs::LaserScan there = message();
  there.ranges = {std::nanf("17"), -std::numeric_limits<float>::infinity(), -0.0F};
  const sensor_msgs::LaserScan back = to_message(as_raw_scan(there), "laser");
  ASSERT_EQ(back.ranges.size(), 3U);
  EXPECT_EQ(std::memcmp(back.ranges.data(), there.ranges.data(), 3 * sizeof(float)), 0);
}

TEST(LaserScanConversion, BorrowsTheArrays) {
  const sensor_msgs::LaserScan scan = message();
  const RawScan raw = as_raw_scan(scan);
  EXPECT_EQ(raw.ranges, scan.ranges.data());
  EXPECT_EQ(raw.range_count, 4U);
  EXPECT_EQ(raw.intensities, scan.intensities.data());
  EXPECT_EQ(raw.intensity_count, 2U);
}

TEST(LaserScanConversion, RoundsToSinglePrecision) {
  RawScan raw;
  raw.angle_min = -std::acos(-1.0);
  raw.angle_increment = std::acos(-1.0) / 720.0;
  raw.range_max = 1e300;
  const sensor_msgs::LaserScan scan = to_message(raw, "laser");
  EXPECT_EQ(scan.angle_increment, static_cast<float>(raw.angle_increment));
  EXPECT_NEAR(static_cast<double>(scan.angle_min), raw.angle_min, 2e-7);
  EXPECT_TRUE(std::isinf(scan.range_max));
}

TEST(LaserScanConversion, TakesAScanWithoutBeams) {
  const RawScan raw = as_raw_scan(sensor_msgs::LaserScan());
  EXPECT_EQ(raw.range_count, 0U);
  EXPECT_EQ(raw.intensity_count, 0U);
  EXPECT_TRUE(to_message(raw, "laser").ranges.empty());
}

TEST(LaserScanConversion, WritesWhatIsNotValidByRep117) {
  sensor_msgs::LaserScan there = message();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  there.range_max = 30.0F;
  there.ranges = {1.5F, 0.0F, kInfinity, 31.0F, 0.01F, std::nanf("")};
  LaserScan scan;
  normalize(as_raw_scan(there), {}, scan);

  const sensor_msgs::LaserScan back = to_message(scan, Time(std::chrono::seconds(7)));

  EXPECT_EQ(back.header.stamp, ros::Time(7));
  ASSERT_EQ(back.ranges.size(), 6U);
  EXPECT_EQ(back.ranges[0], 1.5F);
  EXPECT_EQ(back.ranges[1], 0.0F);
  EXPECT_EQ(back.ranges[2], kInfinity);
  EXPECT_EQ(back.ranges[3], kInfinity);
  EXPECT_EQ(back.ranges[4], -kInfinity);
  EXPECT_TRUE(std::isnan(back.ranges[5]));
  EXPECT_FLOAT_EQ(back.angle_max, back.angle_min + 5.0F * back.angle_increment);
}

TEST(LaserScanConversion, OfAScanWithoutBeamsHasNoRanges) {
  EXPECT_TRUE(to_message(LaserScan(), Time()).ranges.empty());
}

}  // namespace
}  // namespace falko_slam
