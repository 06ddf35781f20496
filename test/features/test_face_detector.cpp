// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/face_detector.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

struct Wall {
  Eigen::Vector2d from, to;
};

// What 1440 beams from the origin see of walls, nearest first.
LaserScan scan_of(const std::vector<Wall>& walls, double noise, std::mt19937_64& random) {
  LaserScan scan;
  scan.angle_min = -kPi;
  scan.angle_increment = kTwoPi / 1440.0;
  scan.closed = true;
  scan.range_max = 100.0;
  for (std::size_t i = 0; i < 1440; ++i) {
    const Eigen::Vector2d sight(std::cos(scan.bearing(i)), std::sin(scan.bearing(i)));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls) {
      const Eigen::Vector2d way = wall.to - wall.from;
      const double turn = sight.x() * way.y() - sight.y() * way.x();
      if (std::abs(turn) < 1e-12) continue;
      const double range = (wall.from.x() * way.y() - wall.from.y() * way.x()) / turn;
      const double place = (wall.from.x() * sight.y() - wall.from.y() * sight.x()) / turn;
      if (range > 0.0 && place >= 0.0 && place <= 1.0) nearest = std::min(nearest, range);
    }
    const bool hit = std::isfinite(nearest);
    scan.ranges.push_back(hit ? nearest + test::normal(random, noise)
                              : std::numeric_limits<double>::quiet_NaN());
    scan.status.push_back(hit ? BeamStatus::kValid : BeamStatus::kNoReturn);
  }
  return scan;
}

TEST(FaceDetector, FindsAFaceWithItsEndsAndNormal) {
  std::mt19937_64 random = test::seeded_random();
  const auto faces = detect_faces(scan_of({{{2.0, -1.0}, {2.0, 1.0}}}, 1e-4, random), {});
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_NEAR(faces[0].line.normal.x(), 1.0, 1e-3);
  EXPECT_NEAR(faces[0].line.offset, 2.0, 1e-3);
  EXPECT_NEAR(faces[0].middle.y(), 0.0, 0.02);
  EXPECT_NEAR(faces[0].half_length, 1.0, 0.04);
}

// The seam of a closed scan looks backwards.
TEST(FaceDetector, GoesOnAcrossTheSeam) {
  std::mt19937_64 random = test::seeded_random();
  const auto faces = detect_faces(scan_of({{{-3.0, -2.0}, {-3.0, 1.0}}}, 0.005, random), {});
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_NEAR(faces[0].half_length, 1.5, 0.06);
  EXPECT_LT(faces[0].last_beam, faces[0].first_beam);
}

TEST(FaceDetector, SplitsACorner) {
  std::mt19937_64 random = test::seeded_random();
  const LaserScan scan =
      scan_of({{{2.0, -1.5}, {2.0, 1.5}}, {{2.0, 1.5}, {-1.0, 1.5}}}, 0.008, random);
  const auto faces = detect_faces(scan, {});
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_NEAR(std::abs(faces[0].line.normal.dot(faces[1].line.normal)), 0.0, 0.02);
}

// Pallets in a row, seen at a grazing angle, the second two centimetres behind: less than three
// times the noise of a range, far more than its part across the faces.
TEST(FaceDetector, TellsApartWhatIsNearlyInLine) {
  std::mt19937_64 random = test::seeded_random();
  const LaserScan scan =
      scan_of({{{1.5, 1.35}, {2.3, 1.35}}, {{2.3, 1.37}, {3.1, 1.37}}}, 0.008, random);
  FaceDetectorParams params;
  params.straightness = 0.003;
  const auto faces = detect_faces(scan, params);
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_NEAR(std::abs(faces[0].middle.y() - faces[1].middle.y()), 0.02, 0.006);
  params.straightness = 0.02;  // what bends by as much may as well be one
  EXPECT_EQ(detect_faces(scan, params).size(), 1U);
}

TEST(FaceDetector, LeavesAStraightWallWhole) {
  std::mt19937_64 random = test::seeded_random();
  for (int i = 0; i < 50; ++i) {
    const LaserScan scan = scan_of({{{-6.0, 2.0}, {6.0, 2.0}}}, 0.008, random);
    EXPECT_EQ(detect_faces(scan, {}).size(), 1U);
  }
}

// 500 faces in any direction: errors are what the covariance says, or less.
TEST(FaceDetector, KnowsItsErrors) {
  std::mt19937_64 random = test::seeded_random();
  FaceDetectorParams params;
  params.straightness = 1e-4;
  double nees = 0.0;
  int count = 0;
  for (int i = 0; i < 500; ++i) {
    const double angle = test::uniform(random, -kPi, kPi), distance = test::uniform(random, 1.5, 4);
    const Eigen::Vector2d normal(std::cos(angle), std::sin(angle)), along(-normal.y(), normal.x());
    const double beside = test::uniform(random, -3.0, 3.0);
    const Eigen::Vector2d middle = distance * normal + beside * along;
    const auto faces = detect_faces(
        scan_of({{middle - 0.5 * along, middle + 0.5 * along}}, 0.008, random), params);
    if (faces.size() != 1) continue;
    const DetectedFace& face = faces[0];
    const Eigen::Vector2d error(
        angle_between(angle, std::atan2(face.line.normal.y(), face.line.normal.x())),
        normal.dot(face.middle) - distance);
    nees += error.dot(face.covariance.inverse() * error);
    ++count;
  }
  EXPECT_GT(count, 450);
  EXPECT_GT(nees / count, 1.2);
  EXPECT_LT(nees / count, 2.6);
}

TEST(FaceDetector, TakesScansWithoutAnything) {
  EXPECT_TRUE(detect_faces({}, {}).empty());
  std::mt19937_64 random = test::seeded_random();
  EXPECT_TRUE(detect_faces(scan_of({}, 0.0, random), {}).empty());
}

TEST(FaceDetectorParams, AreValidated) {
  FaceDetectorParams params;
  params.straightness = 0.0;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("straightness = 0"), std::string::npos);
  }
}

}  // namespace
}  // namespace falko_slam
