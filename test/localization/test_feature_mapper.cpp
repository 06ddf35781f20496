// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/feature_mapper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// Scans that see ordinary surfaces 20 m away and, where told, corners that stand before them.
class FeatureMapping : public ::testing::Test {
 protected:
  static LaserScan open_scan() {
    LaserScan scan;
    scan.angle_min = -kPi;
    scan.angle_increment = kTwoPi / 1440;
    scan.closed = true;
    scan.range_max = 100.0;
    scan.ranges.assign(1440, 20.0);
    scan.status.assign(1440, BeamStatus::kValid);
    return scan;
  }

  // Puts a surface as wide as a hand there.
  static void cover(LaserScan& scan, const Eigen::Vector2d& in_laser) {
    const double half_angle = 0.05 / in_laser.norm();
    const double bearing = std::atan2(in_laser.y(), in_laser.x());
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const double off = std::remainder(scan.bearing(i) - bearing, kTwoPi);
      if (std::abs(off) <= half_angle) scan.ranges[i] = std::min(scan.ranges[i], in_laser.norm());
    }
  }

  static PointEstimate seen_at(const Eigen::Vector2d& in_laser) {
    return {in_laser, 1e-4 * Eigen::Matrix2d::Identity()};
  }

  // Drives past corners along the x axis, turning, with a scan every 10 cm.
  void drive(FeatureMapper& mapper, const std::vector<Eigen::Vector2d>& corners, double from,
             int scans, double noise) {
    for (int i = 0; i < scans; ++i) {
      const double x = from + 0.1 * i;
      const Pose2 map_T_laser(x, 0.0, 0.3 * x);
      LaserScan scan = open_scan();
      std::vector<PointEstimate> keypoints;
      for (const Eigen::Vector2d& corner : corners) {
        const Eigen::Vector2d in_laser = map_T_laser.inverse() * corner;
        cover(scan, in_laser);
        keypoints.push_back(seen_at(in_laser + Eigen::Vector2d(test::normal(random_, noise),
                                                               test::normal(random_, noise))));
      }
      mapper.add(map_T_laser, scan, keypoints);
    }
  }

  std::mt19937_64 random_ = test::seeded_random();
};

TEST_F(FeatureMapping, FindsTheCornersOfADrive) {
  const std::vector<Eigen::Vector2d> corners = {{2.0, 3.0}, {1.0, -2.0}, {4.0, 2.5}};
  FeatureMapper mapper;
  drive(mapper, corners, 0.0, 50, 0.01);
  const FeatureMap result = mapper.build();
  ASSERT_EQ(result.map.landmarks.size(), 3U);
  const std::vector<Eigen::Vector2d> by_x = {corners[1], corners[0], corners[2]};
  for (std::size_t i = 0; i < 3; ++i) {
    const MapLandmark& landmark = result.map.landmarks[i];
    EXPECT_EQ(landmark.kind, LandmarkKind::kFeature);
    EXPECT_EQ(landmark.id, static_cast<int>(i));
    EXPECT_EQ(landmark.hits, 50);
    EXPECT_LT((landmark.position - by_x[i]).norm(), 0.01);
  }
  EXPECT_EQ(result.report.keypoints, 150U);
  EXPECT_EQ(result.report.keypoints_of_features, 150U);
  EXPECT_NO_THROW(validate(result.map));
}

// A hundred scans from one place tell no more than one, and a lasting error of theirs is no noise.
TEST_F(FeatureMapping, ScatterBetweenViewpointsIsTheCovariance) {
  FeatureMapperParams params;
  params.min_viewpoints = 2;
  FeatureMapper mapper(params);
  const Eigen::Vector2d corner(0.0, 4.0);
  constexpr int kViewpoints = 40;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), squares = sum;
  for (int viewpoint = 0; viewpoint < kViewpoints; ++viewpoint) {
    const Pose2 map_T_laser(-4.0 + 0.5 * viewpoint, 0.0, 0.0);
    const Eigen::Vector2d bias(test::normal(random_, 0.02), test::normal(random_, 0.004));
    sum += bias;
    squares += bias.cwiseProduct(bias);
    const Eigen::Vector2d in_laser = map_T_laser.inverse() * (corner + bias);
    LaserScan scan = open_scan();
    cover(scan, in_laser);
    for (int i = 0; i < 1 + viewpoint; ++i) mapper.add(map_T_laser, scan, {seen_at(in_laser)});
  }
  const FeatureMap result = mapper.build();
  ASSERT_EQ(result.map.landmarks.size(), 1U);
  const MapLandmark& landmark = result.map.landmarks[0];
  EXPECT_LT((landmark.position - corner - sum / kViewpoints).norm(), 0.002);
  const Eigen::Vector2d variance = squares / kViewpoints;
  EXPECT_NEAR(std::sqrt(landmark.covariance(0, 0)), std::sqrt(variance.x()), 0.002);
  EXPECT_NEAR(std::sqrt(landmark.covariance(1, 1)), std::sqrt(variance.y()), 0.002);
}

TEST_F(FeatureMapping, WhatStoodForAWhileOnlyIsLeftOut) {
  const Eigen::Vector2d wall(2.0, 3.0), parked(3.0, -2.0);
  FeatureMapper mapper;
  drive(mapper, {wall, parked}, 0.0, 20, 0.005);
  drive(mapper, {wall}, 2.0, 50, 0.005);
  const FeatureMap result = mapper.build();
  ASSERT_EQ(result.map.landmarks.size(), 1U);
  EXPECT_LT((result.map.landmarks[0].position - wall).norm(), 0.01);
  EXPECT_EQ(result.report.too_small_share, 1U);
}

TEST_F(FeatureMapping, WhatIsHiddenIsNotMissed) {
  const Eigen::Vector2d corner(2.0, 3.0);
  FeatureMapper mapper;
  drive(mapper, {corner}, 0.0, 20, 0.005);
  for (int i = 0; i < 100; ++i) {
    LaserScan scan = open_scan();
    scan.ranges.assign(scan.size(), 1.0);
    mapper.add({2.0 + 0.1 * i, 0.0, 0.0}, scan, {});
  }
  EXPECT_EQ(mapper.build().map.landmarks.size(), 1U);
}

TEST_F(FeatureMapping, ACornerSeenFromOnePlaceOnlyIsLeftOut) {
  FeatureMapper mapper;
  LaserScan scan = open_scan();
  cover(scan, {2.0, 1.0});
  for (int i = 0; i < 100; ++i) mapper.add({}, scan, {seen_at({2.0, 1.0})});
  const FeatureMap result = mapper.build();
  EXPECT_TRUE(result.map.landmarks.empty());
  EXPECT_EQ(result.report.too_few_hits, 1U);
}

TEST_F(FeatureMapping, KeepsAwayFromWhatIsKnownAndFromBetterOnes) {
  LandmarkMap known;
  MapLandmark reflector;
  reflector.id = 41;
  reflector.position = {4.0, 2.4};
  known.landmarks = {reflector};
  FeatureMapper mapper;
  drive(mapper, {{2.0, 3.0}, {4.0, 2.5}}, 0.0, 50, 0.005);
  drive(mapper, {{2.0, 3.12}}, 5.0, 30, 0.005);
  const FeatureMap result = mapper.build(known);
  ASSERT_EQ(result.map.landmarks.size(), 2U);
  EXPECT_EQ(result.map.landmarks[0].id, 41);
  EXPECT_EQ(result.map.landmarks[0].position, reflector.position);
  EXPECT_EQ(result.map.landmarks[1].id, 42);
  EXPECT_LT((result.map.landmarks[1].position - Eigen::Vector2d(2.0, 3.0)).norm(), 0.01);
}

TEST_F(FeatureMapping, LeavesOutWhatIsNoPoint) {
  FeatureMapper mapper;
  mapper.add({}, open_scan(),
             {seen_at({std::nan(""), 0.0}), {{1.0, 1.0}, -Eigen::Matrix2d::Identity()}});
  EXPECT_EQ(mapper.build().report.keypoints, 0U);
}

TEST_F(FeatureMapping, RefusesParametersThatAreNone) {
  FeatureMapperParams params;
  params.min_share = 1.5;
  try {
    FeatureMapper mapper(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "min_share = 1.5: must be in [0, 1]");
  }
}

}  // namespace
}  // namespace falko_slam
