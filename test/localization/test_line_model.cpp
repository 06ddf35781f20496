// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/line_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "localization/landmark_drive.hpp"
#include "localization/numeric_slope.hpp"
#include "seen_feature.hpp"

namespace falko_slam {
namespace {

using test::kStep;
using test::shifted;

Pose2 random_pose(std::mt19937_64& random) {
  const double x = test::uniform(random, -9.0, 9.0), y = test::uniform(random, -9.0, 9.0);
  return {x, y, test::uniform(random, -kPi, kPi)};
}

Eigen::Vector2d slope(const Eigen::Vector2d& after, const Eigen::Vector2d& before) {
  Eigen::Vector2d difference = after - before;
  difference.x() = wrap_angle(difference.x());
  return difference / (2.0 * kStep);
}

TEST(LineModel, HasTheJacobiansOfNumericDifferentiation) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 100; ++run) {
    const Pose2 map_T_base = random_pose(random);
    const MapLine line{test::uniform(random, -kPi, kPi), test::uniform(random, -5.0, 5.0),
                       random_pose(random).translation()};
    const auto prediction = predict_line(map_T_base, test::kLaserMount, line);
    const auto value = [&](const Pose2& pose, const MapLine& of) {
      return predict_line(pose, test::kLaserMount, of).value;
    };
    for (int i = 0; i < 3; ++i) {
      const auto numeric = slope(value(shifted(map_T_base, i, kStep), line),
                                 value(shifted(map_T_base, i, -kStep), line));
      EXPECT_LT((prediction.dvalue_dpose.col(i) - numeric).norm(), 1e-6);
    }
    MapLine turned = line, turned_back = line, moved = line, moved_back = line;
    turned.angle += kStep;
    turned_back.angle -= kStep;
    moved.offset += kStep;
    moved_back.offset -= kStep;
    const auto dangle = slope(value(map_T_base, turned), value(map_T_base, turned_back));
    const auto doffset = slope(value(map_T_base, moved), value(map_T_base, moved_back));
    EXPECT_LT((prediction.dvalue_dline.col(0) - dangle).norm(), 1e-6);
    EXPECT_LT((prediction.dvalue_dline.col(1) - doffset).norm(), 1e-6);
  }
}

TEST(LineModel, ALineOfTheMapIsSeenAsItWas) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 50; ++run) {
    const Pose2 map_T_base = random_pose(random);
    LineObservation seen;
    seen.value << test::uniform(random, -kPi, kPi), test::uniform(random, 0.1, 9.0);
    const auto back = predict_line(map_T_base, test::kLaserMount,
                                   line_in_map(map_T_base, test::kLaserMount, seen))
                          .value;
    EXPECT_LT((back - seen.value).norm(), 1e-12);
  }
}

TEST(LineModel, HasItsNormalLeftOfItsDirection) {
  const MapLine line{0.3, 2.0, {5.0, -1.0}};
  const Eigen::Vector2d along = direction_of(line), normal(std::cos(0.3), std::sin(0.3));

  EXPECT_NEAR(along.x() * normal.y() - along.y() * normal.x(), 1.0, 1e-12);
}

TEST(LineModel, IsNearestToAPointAtARightAngle) {
  const MapLine line{0.3, 2.0, {5.0, -1.0}};
  const Eigen::Vector2d point(-3.0, 8.0), normal(std::cos(0.3), std::sin(0.3));
  const Eigen::Vector2d nearest = nearest_point(line, point);

  EXPECT_NEAR(normal.dot(nearest - line.anchor), line.offset, 1e-12);
  EXPECT_NEAR(direction_of(line).dot(nearest - point), 0.0, 1e-12);
}

// The anchor stays where the laser was believed to be, whatever the pose truly was.
TEST(BornLandmark, HangsOnThePoseAsNumericDifferentiationSays) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 100; ++run) {
    const Pose2 map_T_base = random_pose(random);
    SeenFeature seen;
    seen.is_line = run % 2 == 0;
    seen.line.value << test::uniform(random, -3.0, 3.0), test::uniform(random, 0.1, 9.0);
    seen.line.covariance = test::diagonal(0.01, 0.02);
    const BornLandmark landmark = born(map_T_base, test::kLaserMount, seen);
    const Eigen::Vector2d anchor = (map_T_base * test::kLaserMount).translation();
    const auto value = [&](const Pose2& pose) -> Eigen::Vector2d {
      if (!seen.is_line) return pose * test::kLaserMount * seen.line.value;
      const MapLine line = line_in_map(pose, test::kLaserMount, seen.line);
      const Eigen::Vector2d normal(std::cos(line.angle), std::sin(line.angle));
      return {line.angle, line.offset + normal.dot(line.anchor - anchor)};
    };
    for (int i = 0; i < 3; ++i) {
      Eigen::Vector2d numeric =
          value(shifted(map_T_base, i, kStep)) - value(shifted(map_T_base, i, -kStep));
      if (seen.is_line) numeric.x() = wrap_angle(numeric.x());
      EXPECT_LT((landmark.dlandmark_dpose.col(i) - numeric / (2.0 * kStep)).norm(), 1e-6);
    }
  }
}

TEST(LineObservation, IsUsableOnlyIfWhole) {
  LineObservation good{{0.3, 2.0}, test::diagonal(0.01, 0.01), {1.0, 1.0}, 0.4};
  EXPECT_TRUE(is_usable(good));
  LineObservation bad = good;
  bad.value.y() = -1.0;
  EXPECT_FALSE(is_usable(bad));
  bad = good;
  bad.half_length = std::nan("");
  EXPECT_FALSE(is_usable(bad));
  bad = good;
  bad.covariance.setZero();
  EXPECT_FALSE(is_usable(bad));
}

}  // namespace
}  // namespace falko_slam
