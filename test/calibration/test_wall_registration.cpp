// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/wall_registration.hpp"

#include <gtest/gtest.h>

#include "falko_slam/calibration/mean_scan.hpp"
#include "walled_halls.hpp"

namespace falko_slam {
namespace {

const Pose2 kWorldTTarget(1.0, -2.5, 0.4);
const Pose2 kTargetTSource(3.0, 2.0, 2.9);
const Eigen::Matrix3d kOpen = pose_covariance(1.0, 0.3).inverse();

WallScan walls_of(const Scene& scene, const Pose2& pose, double noise, std::mt19937_64& random,
                  double field_of_view = kTwoPi) {
  const MeanScan mean =
      mean_of(test::scans_at_rest(scene, pose, test::hall_laser(noise, field_of_view), random));
  return WallScan(mean.scan, noise / std::sqrt(static_cast<double>(mean.scans)));
}

std::optional<WallRegistration> registered(const Scene& scene, double noise,
                                           std::mt19937_64& random, double lasting_noise,
                                           double field_of_view = kTwoPi) {
  WallRegistrationParams params;
  params.lasting_noise = lasting_noise;
  const Pose2 nearby = kTargetTSource * Pose2(0.03, -0.02, 0.004);
  return register_walls(
      walls_of(scene, kWorldTTarget, noise, random, field_of_view),
      walls_of(scene, kWorldTTarget * kTargetTSource, noise, random, field_of_view), nearby, kOpen,
      params);
}

TEST(WallRegistration, IsExactWithoutNoise) {
  auto random = test::seeded_random();
  const auto found = registered(test::walled_hall(), 0.0, random, 0.0005);

  ASSERT_TRUE(found);
  const Eigen::Vector3d error = test::error_of(found->target_T_source, kTargetTSource);
  EXPECT_LT(error.head<2>().norm(), 2e-5);
  EXPECT_LT(std::abs(error.z()), 2e-6);
  EXPECT_GT(found->agreement(), 0.98);
}

TEST(WallRegistration, ErrsAsMuchAsItsCovarianceSays) {
  auto random = test::seeded_random();
  constexpr int kTrials = 150;
  for (const double field_of_view : {kTwoPi, 1.5 * kPi}) {
    double squares = 0.0;
    Eigen::Vector3d whitened_sum = Eigen::Vector3d::Zero();
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto found = registered(test::walled_hall(), 0.008, random, 0.0, field_of_view);
      ASSERT_TRUE(found);
      squares += test::squared_error({found->target_T_source, found->covariance}, kTargetTSource) /
                 kTrials;
      whitened_sum += test::error_of(found->target_T_source, kTargetTSource)
                          .cwiseQuotient(found->covariance.diagonal().cwiseSqrt());
    }
    // Chi-square of 450 degrees of freedom, 99.9 %.
    EXPECT_GT(squares, 2.4) << field_of_view;
    EXPECT_LT(squares, 3.7) << field_of_view;
    // No bias.
    EXPECT_LT(whitened_sum.cwiseAbs().maxCoeff(), 3.3 * std::sqrt(kTrials)) << field_of_view;
  }
}

TEST(WallRegistration, CountsWhatLastsOnceForEachPartOfAWall) {
  auto random = test::seeded_random();
  const auto without = registered(test::walled_hall(), 0.001, random, 0.0);
  const auto with = registered(test::walled_hall(), 0.001, random, 0.002);

  ASSERT_TRUE(without && with);
  EXPECT_GT(with->covariance.trace(), 5.0 * without->covariance.trace());
  EXPECT_LT(without->lasting_covariance.trace(), 1e-12);
  EXPECT_GT(with->lasting_covariance.trace(), 0.9 * with->covariance.trace());
  // Of some 30 parts, half of which look along each axis: 2 mm * sqrt(2 / 15), and no less.
  EXPECT_NEAR(std::sqrt(with->covariance(0, 0)), 0.0008, 0.0004);
}

TEST(WallRegistration, SaysThatACorridorIsOpen) {
  auto random = test::seeded_random();
  Scene corridor;
  corridor.walls = {{{-200.0, 1.5}, {200.0, 1.5}}, {{200.0, -1.5}, {-200.0, -1.5}}};
  for (int trial = 0; trial < 20; ++trial) {
    const Pose2 truth(2.0, 0.3, 0.2), nearby = truth * Pose2(0.05, 0.01, 0.0);
    const auto found = register_walls(walls_of(corridor, {}, 0.008, random),
                                      walls_of(corridor, truth, 0.008, random), nearby, kOpen);

    ASSERT_TRUE(found);
    EXPECT_GT(std::sqrt(found->covariance(0, 0)), 0.05);
    EXPECT_LT(std::sqrt(found->covariance(1, 1)), 0.003);
    EXPECT_LT(test::squared_error({found->target_T_source, found->covariance}, truth), 20.0);
  }
}

TEST(WallRegistration, LeavesOutWhatHasMoved) {
  auto random = test::seeded_random();
  Scene moved = test::walled_hall();
  for (std::size_t i = 4; i < 16; ++i) {  // the sides of three boxes
    moved.walls[i].from += Eigen::Vector2d(0.04, -0.03);
    moved.walls[i].to += Eigen::Vector2d(0.04, -0.03);
  }
  const auto found = register_walls(walls_of(test::walled_hall(), kWorldTTarget, 0.005, random),
                                    walls_of(moved, kWorldTTarget * kTargetTSource, 0.005, random),
                                    kTargetTSource, kOpen);

  ASSERT_TRUE(found);
  EXPECT_LT(test::squared_error({found->target_T_source, found->covariance}, kTargetTSource), 16.0);
  EXPECT_GT(found->contradicting_length, 0.5);
  EXPECT_GT(found->agreement(), 0.9);
}

TEST(WallRegistration, SaysWhatTheyContradict) {
  auto random = test::seeded_random();
  Scene other = test::walled_hall();
  for (Wall& wall : other.walls) {  // half of the hall is elsewhere
    if (wall.from.x() + wall.to.x() < 2.0) continue;
    wall.from.x() += 1.0;
    wall.to.x() += 1.0;
  }
  const auto found = register_walls(walls_of(test::walled_hall(), kWorldTTarget, 0.005, random),
                                    walls_of(other, kWorldTTarget * kTargetTSource, 0.005, random),
                                    kTargetTSource, kOpen);

  ASSERT_TRUE(found);
  EXPECT_LT(found->agreement(), 0.8);
}

TEST(WallRegistration, OfNothingSaysNothing) {
  const auto found = register_walls(WallScan(), WallScan(), {}, kOpen);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->parts, 0U);
  EXPECT_TRUE(found->covariance.isApprox(kOpen.inverse()));
  EXPECT_FALSE(register_walls(WallScan(), WallScan(), {}, Eigen::Matrix3d::Zero()));
}

TEST(WallRegistration, RefusesBadParameters) {
  WallRegistrationParams params;
  params.lasting_noise = -1.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.last_gate = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
