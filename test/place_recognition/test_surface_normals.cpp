// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/surface_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

// A room of 6 m by 4 m about the laser, which is turned by `heading`.
LaserScan room(double heading) {
  auto random = test::seeded_random();
  Scene scene;
  scene.add_box({0.0, 0.0, 0.0}, {6.0, 4.0});
  return test::closed_scan(scene, {0.0, 0.0, heading}, 720, 0.0, random);
}

TEST(SurfaceNormals, PointFromTheWallsToTheLaserWhateverItsHeading) {
  for (double heading = -3.0; heading < 3.0; heading += 0.1) {
    const Pose2 laser_T_room = Pose2(0.0, 0.0, heading).inverse();
    const std::vector<Eigen::Vector2d> places = {{3.0, 0.2}, {0.4, 2.0}, {-3.0, 0.3}, {0.1, -2.0}};
    std::vector<Eigen::Vector2d> in_laser;
    for (const auto& place : places) in_laser.push_back(laser_T_room * place);
    const auto normals = surface_normals(room(heading), in_laser);
    ASSERT_EQ(normals.size(), places.size());
    const double expected[] = {kPi, -kPi / 2.0, 0.0, kPi / 2.0};
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_NEAR(angle_between(expected[i], normals[i] + heading), 0.0, 1e-3) << heading << i;
    }
  }
}

TEST(SurfaceNormals, AreNoneWhereTheScanHasTooFewPoints) {
  SurfaceNormalParams params;
  const auto normals = surface_normals(room(0.0), {{0.0, 0.0}, {40.0, 0.0}, {3.0, 0.1}}, params);
  EXPECT_TRUE(std::isnan(normals[0]));
  EXPECT_TRUE(std::isnan(normals[1]));
  EXPECT_FALSE(std::isnan(normals[2]));
  params.min_points = 1000;
  EXPECT_TRUE(std::isnan(surface_normals(room(0.0), {{3.0, 0.1}}, params)[0]));
}

TEST(SurfaceNormals, AreNoneWhereThePointsSpreadAlikeInAllDirections) {
  // Three beams that end in the corners of an equilateral triangle; all in one cell.
  const double apart = 0.1;
  const double far = std::cos(apart) + std::sqrt(3.0) * std::sin(apart);
  SurfaceNormalParams params;
  params.cell_size = 100.0;
  const auto scan = test::scan_of({1.0, far, 1.0}, 0.5, apart);
  EXPECT_TRUE(std::isnan(surface_normals(scan, {{1.0, 1.0}}, params)[0]));
  const auto wall = test::scan_of({1.0, 1.0, 1.0}, 0.5, apart);
  EXPECT_FALSE(std::isnan(surface_normals(wall, {{1.0, 1.0}}, params)[0]));
}

TEST(SurfaceNormals, OfAnEmptyScanAreNone) {
  EXPECT_TRUE(surface_normals(LaserScan(), {}).empty());
  EXPECT_TRUE(std::isnan(surface_normals(LaserScan(), {{1.0, 1.0}})[0]));
  const LaserScan blind = test::circle_of(std::vector<double>(36, test::kNoRange));
  EXPECT_TRUE(std::isnan(surface_normals(blind, {{1.0, 1.0}})[0]));
}

TEST(SurfaceNormalParams, NameFieldAndValueOfWhatIsWrong) {
  SurfaceNormalParams params;
  params.cell_size = 0.0;
  try {
    surface_normals(LaserScan(), {}, params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "cell_size = 0: must be in [0.01, 100]");
  }
}

}  // namespace
}  // namespace falko_slam
