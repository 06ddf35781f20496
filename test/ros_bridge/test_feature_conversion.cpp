// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/feature_conversion.hpp"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "support/seeds.hpp"
#include "support/simulated_laser.hpp"

namespace falko_slam {
namespace {

constexpr double kScanTime = 0.144;
const SimulatedLaserParams kLaser;

// What a laser in the office measures: the message does not tell how it is mounted.
sensor_msgs::LaserScan office_message() {
  auto random = test::seeded_random();
  sensor_msgs::LaserScan message;
  message.header.stamp = ros::Time(100, 0);
  message.header.frame_id = "laser";
  message.angle_min = static_cast<float>(kLaser.angle_min);
  message.angle_increment = static_cast<float>(kLaser.angle_increment);
  message.time_increment = static_cast<float>(kScanTime / static_cast<double>(kLaser.beams));
  message.range_max = 100.0F;
  message.ranges = simulate_ranges(office_scene(), {-3.0, -1.0, 0.4}, kLaser, random);
  return message;
}

class FeatureConversion : public ::testing::TestWithParam<bool> {
 protected:
  FeatureConversion() : message_(office_message()), extractor_(params()) {
    extractor_.extract(as_raw_scan(message_));
    features_ = to_message(extractor_, message_.header);
  }
  static FeatureExtractorParams params() {
    FeatureExtractorParams params;
    params.scan.upside_down = GetParam();
    return params;
  }

  sensor_msgs::LaserScan message_;
  FeatureExtractor extractor_;
  FeatureArray features_;
};
INSTANTIATE_TEST_SUITE_P(Mounts, FeatureConversion, ::testing::Bool(),
                         [](const auto& mount) { return mount.param ? "UpsideDown" : "Upright"; });

TEST_P(FeatureConversion, TellsWhatTheFeaturesWereFoundWith) {
  EXPECT_EQ(features_.header, message_.header);
  EXPECT_EQ(features_.upside_down != 0, GetParam());
  EXPECT_EQ(features_.descriptor_radius, 0.5);
  EXPECT_EQ(features_.bsc_rings, 8U);
  EXPECT_EQ(features_.sectors, 16U);
  EXPECT_EQ(features_.cgh_sigma, 0.6);
  ASSERT_EQ(features_.features.size(), extractor_.features().size());
  EXPECT_GT(features_.features.size(), 5U);
}

// Whichever way the laser hangs: a feature lies where its beam of the message ends.
TEST_P(FeatureConversion, PositionsAreInTheFrameOfTheMessage) {
  for (const Feature& feature : features_.features) {
    ASSERT_LT(feature.index, message_.ranges.size());
    const double bearing = static_cast<double>(message_.angle_min) +
                           feature.index * static_cast<double>(message_.angle_increment);
    const auto range = static_cast<double>(message_.ranges[feature.index]);
    EXPECT_LT(std::hypot(feature.position.x - range * std::cos(bearing),
                         feature.position.y - range * std::sin(bearing)),
              0.3);
    EXPECT_EQ(feature.position.z, 0.0);
  }
}

TEST_P(FeatureConversion, AnUpsideDownLaserMirrorsPositionsAndAngles) {
  const double mirror = GetParam() ? -1.0 : 1.0;
  for (std::size_t i = 0; i < features_.features.size(); ++i) {
    const Keypoint& keypoint = extractor_.features()[i].keypoint;
    const Feature& feature = features_.features[i];
    EXPECT_EQ(feature.position.x, keypoint.position.x());
    EXPECT_EQ(feature.position.y, mirror * keypoint.position.y());
    EXPECT_NEAR(angle_between(feature.orientation, mirror * keypoint.orientation), 0.0, 1e-12);
    EXPECT_GE(feature.orientation, -kPi);
    EXPECT_LT(feature.orientation, kPi);
    EXPECT_EQ(feature.radius, keypoint.radius);
    EXPECT_EQ(feature.score, keypoint.score);
    EXPECT_EQ(feature.roughness, keypoint.roughness);
  }
}

TEST_P(FeatureConversion, TimeOffsetsAreThoseOfTheBeams) {
  for (const Feature& feature : features_.features) {
    EXPECT_NEAR(feature.time_offset.toSec(),
                feature.index * kScanTime / static_cast<double>(kLaser.beams), 1e-6);
  }
}

TEST_P(FeatureConversion, DescriptorsKeepTheirBitsAndBins) {
  for (std::size_t i = 0; i < features_.features.size(); ++i) {
    const DescribedKeypoint& from = extractor_.features()[i];
    const Feature& to = features_.features[i];
    ASSERT_EQ(to.bsc.size(), 16U);  // 8 rings of 16 sectors, eight cells to a byte
    for (std::size_t cell = 0; cell < 128; ++cell) {
      EXPECT_EQ((to.bsc[cell / 8] >> (cell % 8) & 1) != 0, from.bsc.cell(cell));
    }
    EXPECT_EQ(to.cgh, from.cgh.bins);
  }
}

TEST_P(FeatureConversion, MarkersAreTwoLists) {
  using visualization_msgs::Marker;
  const auto markers = to_markers(features_).markers;
  ASSERT_EQ(markers.size(), 2U);
  EXPECT_EQ(markers[0].type, Marker::SPHERE_LIST);
  EXPECT_EQ(markers[1].type, Marker::LINE_LIST);
  EXPECT_NE(markers[0].ns, markers[1].ns);
  for (const Marker& marker : markers) {
    EXPECT_EQ(marker.header, message_.header);
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_EQ(marker.lifetime, ros::Duration(1.0));
    EXPECT_GT(marker.color.a, 0.0F);
    EXPECT_GT(marker.scale.x, 0.0);
  }
}

TEST_P(FeatureConversion, MarkersShowPositionsAndOrientations) {
  const auto markers = to_markers(features_).markers;
  ASSERT_EQ(markers.at(0).points.size(), features_.features.size());
  ASSERT_EQ(markers.at(1).points.size(), 2 * features_.features.size());
  for (std::size_t i = 0; i < features_.features.size(); ++i) {
    const Feature& feature = features_.features[i];
    EXPECT_EQ(markers[0].points[i], feature.position);
    EXPECT_EQ(markers[1].points[2 * i], feature.position);
    const geometry_msgs::Point& tip = markers[1].points[2 * i + 1];
    EXPECT_NEAR(std::atan2(tip.y - feature.position.y, tip.x - feature.position.x),
                feature.orientation, 1e-9);
  }
}

TEST_P(FeatureConversion, TheCloudHasRoughnessAsIntensity) {
  const sensor_msgs::PointCloud2 cloud = to_cloud(features_);
  EXPECT_EQ(cloud.header.frame_id, "laser");
  EXPECT_EQ(cloud.header.stamp, message_.header.stamp);
  ASSERT_EQ(cloud.width, features_.features.size());
  EXPECT_EQ(cloud.height, 1U);
  EXPECT_EQ(cloud.data.size(), cloud.row_step);
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x"), y(cloud, "y"), z(cloud, "z"),
      intensity(cloud, "intensity");
  for (const Feature& feature : features_.features) {
    EXPECT_EQ(*x, static_cast<float>(feature.position.x));
    EXPECT_EQ(*y, static_cast<float>(feature.position.y));
    EXPECT_EQ(*z, 0.0F);
    EXPECT_EQ(*intensity, static_cast<float>(feature.roughness));
    ++x, ++y, ++z, ++intensity;
  }
}

TEST(FeatureConversionOfNothing, HasEmptyLists) {
  FeatureExtractor extractor;
  extractor.extract(RawScan());
  const FeatureArray features = to_message(extractor, std_msgs::Header());
  EXPECT_TRUE(features.features.empty());
  EXPECT_EQ(to_cloud(features).width, 0U);
  for (const auto& marker : to_markers(features).markers) EXPECT_TRUE(marker.points.empty());
}

}  // namespace
}  // namespace falko_slam
