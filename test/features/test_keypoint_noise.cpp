// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/keypoint_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/surface_step.hpp"

namespace falko_slam {
namespace {

// A wall at y = 1 m along x, seen from 0 to 60 degrees in steps of one; the corner is its far end.
LaserScan wall_ahead() {
  LaserScan scan;
  scan.angle_min = 0.1;
  scan.angle_increment = 0.01;
  scan.range_max = 50.0;
  for (int i = 0; i < 60; ++i) {
    scan.ranges.push_back(1.0 / std::sin(scan.bearing(static_cast<std::size_t>(i))));
    scan.status.push_back(BeamStatus::kValid);
  }
  return scan;
}

Keypoint corner_of(const LaserScan& scan, std::size_t beam) {
  Keypoint corner;
  corner.position = scan.point(beam);
  corner.beam = beam;
  return corner;
}

TEST(KeypointNoise, IsLongAlongAFaceAtAGrazingAngle) {
  const LaserScan scan = wall_ahead();
  KeypointNoise noise;
  noise.range_noise = 1e-4;
  noise.place_noise = 0.0;
  SurfaceStepParams surface;
  surface.max_step = 2.0;
  const Eigen::Matrix2d C = keypoint_covariance(scan, corner_of(scan, 0), noise, surface);
  const double step = (scan.point(1) - scan.point(0)).norm();
  EXPECT_NEAR(std::sqrt(C(0, 0)), step / std::sqrt(12.0), 1e-3);
  EXPECT_LT(C(1, 1), 1e-4);
}

TEST(KeypointNoise, IsThatOfTheBeamWhereTheScanEnds) {
  LaserScan scan = wall_ahead();
  scan.status[1] = BeamStatus::kErroneous;
  scan.ranges[1] = std::numeric_limits<double>::quiet_NaN();
  const KeypointNoise noise{0.01, 0.0, 0.0};
  const Keypoint corner = corner_of(scan, 0);
  const Eigen::Matrix2d C = keypoint_covariance(scan, corner, noise);
  const Eigen::Vector2d sight = corner.position.normalized();
  EXPECT_NEAR(sight.dot(C * sight), 1e-4, 1e-12);
  const Eigen::Vector2d across(-sight.y(), sight.x());
  const double between = corner.position.norm() * scan.angle_increment;
  EXPECT_NEAR(across.dot(C * across), between * between / 12.0, 1e-12);
}

TEST(KeypointNoise, IsValidated) {
  KeypointNoise noise;
  noise.place_noise = -1.0;
  EXPECT_THROW(validate(noise), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
