// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/alignment.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

std::vector<PointPair> pairs_under(const Pose2& target_T_source, int count, double noise,
                                   std::mt19937_64& random) {
  std::vector<PointPair> pairs;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d source(test::uniform(random, -5.0, 5.0),
                                 test::uniform(random, -5.0, 5.0));
    const Eigen::Vector2d error(test::normal(random, noise), test::normal(random, noise));
    pairs.push_back({target_T_source * source + error, source, 1.0});
  }
  return pairs;
}

double cost(const std::vector<PointPair>& pairs, const Pose2& pose) {
  double sum = 0.0;
  for (const auto& pair : pairs) {
    sum += pair.weight * (pose * pair.point_in_source - pair.point_in_target).squaredNorm();
  }
  return sum;
}

TEST(Align, FindsTheExactMotion) {
  auto random = test::seeded_random();
  for (const double theta : {0.0, 1e-9, kPi, -kPi + 1e-9, 2.0, -0.5}) {
    const Pose2 truth(3.0, -2.0, theta);
    const auto result = align(pairs_under(truth, 5, 0.0, random));
    ASSERT_TRUE(result);
    EXPECT_LT(difference(result->target_T_source.pose, truth).norm(), 1e-12);
    EXPECT_LT(result->rms_residual, 1e-12);
  }
}

TEST(Align, SwappedSidesGiveTheInverse) {
  auto random = test::seeded_random();
  auto pairs = pairs_under({1.0, 2.0, 0.8}, 6, 0.05, random);
  const auto forward = align(pairs);
  for (auto& pair : pairs) std::swap(pair.point_in_source, pair.point_in_target);
  const auto backward = align(pairs);
  ASSERT_TRUE(forward && backward);
  const Pose2 round = forward->target_T_source.pose * backward->target_T_source.pose;
  EXPECT_LT(difference(round, Pose2()).norm(), 1e-12);
}

TEST(Align, NoSmallMotionIsBetter) {
  auto random = test::seeded_random();
  auto pairs = pairs_under({1.0, 2.0, 0.8}, 8, 0.1, random);
  for (auto& pair : pairs) pair.weight = test::uniform(random, 0.2, 5.0);
  const auto result = align(pairs);
  ASSERT_TRUE(result);
  const Pose2& best = result->target_T_source.pose;
  for (int i = 0; i < 200; ++i) {
    const Pose2 other(best.x() + test::normal(random, 0.01), best.y() + test::normal(random, 0.01),
                      best.theta() + test::normal(random, 0.01));
    EXPECT_GE(cost(pairs, other), cost(pairs, best));
  }
}

// Squared errors in units of the stated covariance: mean 3 for three coordinates.
TEST(Align, CovarianceIsHonest) {
  auto random = test::seeded_random();
  constexpr double kNoise = 0.02;
  constexpr int kRuns = 3000;
  const Pose2 truth(4.0, 1.0, -2.0);
  double known = 0.0;
  double estimated = 0.0;
  for (int i = 0; i < kRuns; ++i) {
    const auto pairs = pairs_under(truth, 12, kNoise, random);
    for (const double noise : {kNoise, 0.0}) {
      const auto result = align(pairs, noise);
      ASSERT_TRUE(result);
      const Eigen::Vector3d error = difference(result->target_T_source.pose, truth);
      const double nees = error.dot(result->target_T_source.covariance.inverse() * error);
      (noise > 0.0 ? known : estimated) += nees / kRuns;
    }
  }
  EXPECT_NEAR(known, 3.0, 0.15);
  EXPECT_NEAR(estimated, 3.0 * 21.0 / 19.0, 0.2);  // 21 degrees of freedom estimate the noise
}

TEST(Align, RefusesWhatHasNoOrientation) {
  EXPECT_FALSE(align({}));
  EXPECT_FALSE(align({{{1.0, 1.0}, {0.0, 0.0}, 1.0}}));
  EXPECT_FALSE(align({{{1.0, 1.0}, {0.0, 0.0}, 1.0}, {{2.0, 1.0}, {0.0, 0.0}, 1.0}}));
}

TEST(Align, TwoExactPairsHaveNoResidual) {
  const Pose2 truth(0.5, 0.1, 0.2);
  const std::vector<PointPair> pairs = {{truth * Eigen::Vector2d(1.0, 0.0), {1.0, 0.0}, 1.0},
                                        {truth * Eigen::Vector2d(0.0, 2.0), {0.0, 2.0}, 1.0}};
  const auto result = align(pairs);
  ASSERT_TRUE(result);
  EXPECT_LT(difference(result->target_T_source.pose, truth).norm(), 1e-12);
  EXPECT_TRUE(result->target_T_source.covariance.allFinite());
}

}  // namespace
}  // namespace falko_slam
