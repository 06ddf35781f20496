// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/measurement_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "localization/numeric_slope.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

using test::kStep;
using test::shifted;

constexpr ObservationModel kModels[] = {ObservationModel::kCartesian,
                                        ObservationModel::kRangeBearing};

Pose2 random_pose(std::mt19937_64& random, double size) {
  const double x = test::uniform(random, -size, size), y = test::uniform(random, -size, size);
  return {x, y, test::uniform(random, -kPi, kPi)};
}

TEST(MeasurementModel, HasTheJacobiansOfNumericDifferentiation) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 200; ++run) {
    const Pose2 map_T_base = random_pose(random, 20.0), base_T_laser = random_pose(random, 2.0);
    const Eigen::Vector2d landmark = random_pose(random, 20.0).translation();
    for (const ObservationModel model : kModels) {
      const auto value = [&](const Pose2& pose, const Eigen::Vector2d& point) {
        return predict_observation(model, pose, base_T_laser, point).value;
      };
      const auto slope = [&](const Eigen::Vector2d& after, const Eigen::Vector2d& before) {
        return Eigen::Vector2d(innovation_of(model, after, before) / (2.0 * kStep));
      };
      const auto prediction = predict_observation(model, map_T_base, base_T_laser, landmark);
      const double range = (map_T_base * base_T_laser).inverse().operator*(landmark).norm();
      const double tolerance = 1e-6 * (1.0 + 1.0 / (range * range));
      for (int i = 0; i < 3; ++i) {
        const auto numeric = slope(value(shifted(map_T_base, i, kStep), landmark),
                                   value(shifted(map_T_base, i, -kStep), landmark));
        EXPECT_LT((prediction.dvalue_dpose.col(i) - numeric).norm(), tolerance);
      }
      for (int i = 0; i < 2; ++i) {
        const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(i);
        const auto numeric =
            slope(value(map_T_base, landmark + step), value(map_T_base, landmark - step));
        EXPECT_LT((prediction.dvalue_dlandmark.col(i) - numeric).norm(), tolerance);
      }
    }
  }
}

TEST(MeasurementModel, PredictsTheSamePointInBothModels) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 100; ++run) {
    const Pose2 map_T_base = random_pose(random, 20.0), base_T_laser = random_pose(random, 2.0);
    const Eigen::Vector2d landmark = random_pose(random, 20.0).translation();
    for (const ObservationModel model : kModels) {
      LandmarkObservation observation;
      observation.model = model;
      observation.value = predict_observation(model, map_T_base, base_T_laser, landmark).value;
      const Eigen::Vector2d back = map_T_base * base_T_laser * point_in_laser(observation);
      EXPECT_LT((back - landmark).norm(), 1e-9);
    }
  }
}

// (5.14) as printed forgets where the laser is.
TEST(MeasurementModel, SeesFromTheLaserAndNotFromTheRearAxle) {
  const auto prediction = predict_observation(ObservationModel::kRangeBearing,
                                              {1.0, 2.0, 0.5 * kPi}, {1.5, 0.0, kPi}, {1.0, 7.5});
  EXPECT_NEAR(prediction.value.x(), 4.0, 1e-12);
  EXPECT_NEAR(std::abs(prediction.value.y()), kPi, 1e-12);
}

TEST(MeasurementModel, TakesTheBearingTheShorterWayRound) {
  const Eigen::Vector2d observed(5.0, kPi - 1e-3), predicted(5.0, -kPi + 1e-3);
  const auto innovation = innovation_of(ObservationModel::kRangeBearing, observed, predicted);
  EXPECT_NEAR(innovation.y(), -2e-3, 1e-12);
}

TEST(LandmarkObservation, IsUsableOnlyIfFiniteWithACovariance) {
  LandmarkObservation good{ObservationModel::kRangeBearing, {2.0, 0.1}, {}, std::nullopt};
  good.covariance = Eigen::Matrix2d::Identity() * 1e-4;
  EXPECT_TRUE(is_usable(good));

  LandmarkObservation bad = good;
  bad.value.x() = -1.0;
  EXPECT_FALSE(is_usable(bad));
  bad.model = ObservationModel::kCartesian;
  EXPECT_TRUE(is_usable(bad));
  bad.value.y() = std::nan("");
  EXPECT_FALSE(is_usable(bad));
  for (const double entry : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    bad = good;
    bad.covariance(1, 1) = entry;
    EXPECT_FALSE(is_usable(bad)) << entry;
  }
  bad = good;
  bad.covariance(0, 1) = 1e-5;
  EXPECT_FALSE(is_usable(bad)) << "not symmetric";
}

}  // namespace
}  // namespace falko_slam
