// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/external_map_filter.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "localization/landmark_drive.hpp"

namespace falko_slam {
namespace {

const PoseEstimate kStart{{}, pose_covariance(1e-3, 1e-4)};

LandmarkObservation corner_at(double x, double y) {
  LandmarkObservation corner =
      test::seen(ObservationModel::kCartesian, {}, {}, {x, y}, test::diagonal(0.01, 0.01));
  corner.kind = LandmarkKind::kFeature;
  return corner;
}

TEST(ExternalMapFilter, InsertsCountsAndDeletesAsAlgorithm1) {
  ExternalMapFilter filter({}, nullptr, kStart);
  filter.update({corner_at(5, 1)});
  ASSERT_EQ(filter.landmarks().size(), 1U);
  EXPECT_EQ(filter.landmarks()[0].hits, 1);
  filter.update({corner_at(5, 1)});
  EXPECT_EQ(filter.landmarks()[0].hits, 2);
  filter.update({});
  EXPECT_EQ(filter.landmarks()[0].hits, 1);
  filter.update({});
  EXPECT_EQ(filter.landmarks()[0].hits, 0);
  filter.update({});
  EXPECT_TRUE(filter.landmarks().empty());
}

TEST(ExternalMapFilter, MovesALandmarkByTheUpdateRate) {
  ExternalMapParams params;
  params.update_rate = 0.1;
  ExternalMapFilter filter(params, nullptr, {{}, pose_covariance(1e-9, 1e-9)});
  filter.update({corner_at(5.0, 1.0)});
  filter.update({corner_at(5.0, 1.01)});
  ASSERT_EQ(filter.landmarks().size(), 1U);
  EXPECT_NEAR(filter.landmarks()[0].position.y(), 1.001, 1e-6);
}

TEST(ExternalMapFilter, HoldsNoMoreThanItMayAndNoReflectors) {
  ExternalMapParams params;
  params.max_landmarks = 2;
  ExternalMapFilter filter(params, nullptr, kStart);
  LandmarkObservation reflector = corner_at(2, 2);
  reflector.kind = LandmarkKind::kReflector;
  filter.update({reflector, corner_at(5, 1), corner_at(6, 1), corner_at(7, 1)});
  EXPECT_EQ(filter.landmarks().size(), 2U);
}

// What makes it drift: seeing the same corners again makes it ever more sure of a pose that was
// wrong when they were put down.
TEST(ExternalMapFilter, BelievesItsOwnMistakes) {
  const auto map = std::make_shared<LandmarkIndex>(std::vector<Landmark>{});
  ExternalMapFilter filter({}, map, {{0.05, 0.0, 0.0}, pose_covariance(0.05, 0.01)});
  for (int i = 0; i < 30; ++i) filter.update({corner_at(5, 1), corner_at(5, -1)});
  EXPECT_NEAR(filter.map_T_base().pose.x(), 0.05, 1e-6);
  EXPECT_LT(filter.map_T_base().covariance(0, 0), 1e-5);
}

TEST(ExternalMapParams, AreValidated) {
  ExternalMapParams params;
  params.update_rate = 1.5;
  EXPECT_THROW(ExternalMapFilter(params, nullptr, kStart), std::invalid_argument);
  EXPECT_THROW(ExternalMapFilter({}, nullptr, {{}, -kStart.covariance}), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
