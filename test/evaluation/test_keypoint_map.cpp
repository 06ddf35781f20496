// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/keypoint_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/pose2.hpp"

namespace falko_slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// A keypoint seen five times: at its first place, and off it along both axes of `frame`.
std::vector<Points> cross(const Pose2& frame, double a, double b) {
  std::vector<Points> scans;
  for (const Eigen::Vector2d& point :
       {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(a, 0.0), Eigen::Vector2d(-a, 0.0),
        Eigen::Vector2d(0.0, b), Eigen::Vector2d(0.0, -b)}) {
    scans.push_back({frame * point});
  }
  return scans;
}

TEST(KeypointMap, KnowsTheScatterOfACross) {
  // Sample covariance diag(2 a^2, 2 b^2) / 4.
  const double a = 0.04;
  const double b = 0.01;
  for (const double angle : {0.0, 0.6, 3.0}) {
    const auto statistics = keypoint_map_statistics(cross({3.0, -2.0, angle}, a, b), {});
    EXPECT_EQ(statistics.landmarks, 1.0);
    EXPECT_NEAR(statistics.max_deviation, a / std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(statistics.mean_deviation, std::sqrt(0.5 * a * b), 1e-9);
    EXPECT_EQ(statistics.single_share, 0.0);
  }
}

TEST(KeypointMap, KnowsTheScatterOfTwoPoints) {
  // Along a line the smaller eigenvalue is 0; the greater one is d^2 / 2.
  const auto statistics = keypoint_map_statistics({{{0.0, 0.0}}, {{0.03, 0.0}}}, {});
  EXPECT_NEAR(statistics.max_deviation, 0.03 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(statistics.mean_deviation, 0.0, 1e-9);
}

TEST(KeypointMap, AveragesOverTheLandmarksSeenAgain) {
  const auto statistics = keypoint_map_statistics(
      {{{0.0, 0.0}, {5.0, 0.0}, {9.0, 0.0}, {9.0, 5.0}}, {{0.02, 0.0}, {5.04, 0.0}}}, {});
  EXPECT_EQ(statistics.landmarks, 4.0);
  EXPECT_EQ(statistics.single_share, 0.5);
  EXPECT_NEAR(statistics.max_deviation, 0.03 / std::sqrt(2.0), 1e-12);
}

TEST(KeypointMap, LeavesOutWhatIsNeitherNearNorFar) {
  const KeypointMapParams params{0.05, 0.20};
  const auto landmarks_with = [&](double x) {
    return keypoint_map_statistics({{{0.0, 0.0}}, {{x, 0.0}}}, params);
  };
  EXPECT_EQ(landmarks_with(0.04).landmarks, 1.0);
  EXPECT_EQ(landmarks_with(0.04).single_share, 0.0);
  EXPECT_EQ(landmarks_with(0.10).landmarks, 1.0);
  EXPECT_EQ(landmarks_with(0.10).single_share, 1.0);
  EXPECT_EQ(landmarks_with(0.25).landmarks, 2.0);
}

TEST(KeypointMap, ALandmarkStaysWhereItWasFirstSeen) {
  // Each 0.04 m from the one before: only the second is within 0.05 m of the first.
  const auto statistics =
      keypoint_map_statistics({{{0.0, 0.0}}, {{0.04, 0.0}}, {{0.08, 0.0}}}, {0.05, 0.20});
  EXPECT_EQ(statistics.landmarks, 1.0);
  EXPECT_NEAR(statistics.max_deviation, 0.04 / std::sqrt(2.0), 1e-12);
}

TEST(KeypointMap, AKeypointJoinsTheNearestLandmark) {
  const auto statistics = keypoint_map_statistics(
      {{{0.0, 0.0}, {0.25, 0.0}}, {{0.15, 0.0}}, {{0.25, 0.0}}}, {0.20, 0.20});
  // All of 0.15, 0.25 belong to the landmark at 0.25: mean 0.65 / 3.
  const double mean = 0.65 / 3.0;
  const double square = 2.0 * std::pow(0.25 - mean, 2) + std::pow(0.15 - mean, 2);
  EXPECT_EQ(statistics.single_share, 0.5);
  EXPECT_NEAR(statistics.max_deviation, std::sqrt(square / 2.0), 1e-12);
}

TEST(KeypointMap, OfNothingIsNothing) {
  const auto statistics = keypoint_map_statistics({{}, {}}, {});
  EXPECT_EQ(statistics.landmarks, 0.0);
  EXPECT_EQ(statistics.single_share, 0.0);
}

// Three keypoints 0.15 m apart in a row: if the middle one is seen first it is the only landmark,
// else the outer two are. Two out of three orders give two.
TEST(ShuffledKeypointMap, AveragesOverTheOrdersOfTheScans) {
  const std::vector<Points> scans = {{{0.0, 0.0}}, {{0.15, 0.0}}, {{0.30, 0.0}}};
  constexpr std::size_t kOrders = 2000;
  const auto mean = shuffled_keypoint_map_statistics(scans, {0.05, 0.20}, kOrders, 7);
  const double standard_error = std::sqrt(2.0 / 9.0 / kOrders);
  EXPECT_NEAR(mean.landmarks, 5.0 / 3.0, 4.0 * standard_error);
  EXPECT_NEAR(mean.single_share, 1.0, 1e-9);
}

TEST(ShuffledKeypointMap, RepeatsWithItsSeed) {
  const std::vector<Points> scans = {{{0.0, 0.0}}, {{0.15, 0.0}}, {{0.30, 0.0}}};
  const auto landmarks = [&](std::size_t seed) {
    return shuffled_keypoint_map_statistics(scans, {0.05, 0.20}, 101, seed).landmarks;
  };
  EXPECT_EQ(landmarks(1), landmarks(1));
}

TEST(ShuffledKeypointMap, IsThatOfAnyOrderWhereTheOrderIsNothing) {
  const auto scans = cross({1.0, 1.0, 0.3}, 0.02, 0.01);
  const auto one = keypoint_map_statistics(scans, {});
  const auto mean = shuffled_keypoint_map_statistics(scans, {}, 20, 1);
  EXPECT_NEAR(mean.landmarks, one.landmarks, 1e-9);
  EXPECT_NEAR(mean.max_deviation, one.max_deviation, 1e-9);
  EXPECT_NEAR(mean.mean_deviation, one.mean_deviation, 1e-9);
}

}  // namespace
}  // namespace falko_slam
