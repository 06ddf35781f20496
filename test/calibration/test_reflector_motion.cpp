// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/reflector_motion_estimator.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "falko_slam/calibration/reflector_motion.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "reflector_halls.hpp"

namespace falko_slam {
namespace {

const Eigen::Vector3d kHalfCircle(10.0, 0.4, kPi);

double error_of(const ReflectorMotion& motion, const Eigen::Vector3d& arc) {
  return (Pose2::exp(arc).inverse() * motion.start_T_end.pose).log().norm();
}

TEST(ReflectorMotion, IsExactWithoutNoise) {
  auto random = test::seeded_random();
  const ReflectorPoints hall = test::reflector_hall(10, random);
  const auto motion = test::driven(hall, kHalfCircle, 0.0, random).result();

  ASSERT_TRUE(motion);
  EXPECT_LT(error_of(*motion, kHalfCircle), 1e-9);
  EXPECT_NEAR(std::abs(motion->turn), kPi, 1e-9);
  EXPECT_EQ(motion->pairs.size(), 10U);
  EXPECT_EQ(motion->scans, 55U);
}

TEST(ReflectorMotion, CountsWholeTurns) {
  auto random = test::seeded_random();
  const ReflectorPoints hall = test::reflector_hall(10, random);
  const Eigen::Vector3d arc(12.0, 0.0, -7.5);

  const auto motion = test::driven(hall, arc, 0.002, random).result();

  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->turn, -7.5, 0.01);
}

TEST(ReflectorMotion, ErrsAsMuchAsItsCovarianceSays) {
  auto random = test::seeded_random();
  constexpr int kTrials = 300;
  double squares = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const ReflectorPoints hall = test::reflector_hall(8, random);
    const auto motion = test::driven(hall, kHalfCircle, 0.006, random).result();
    ASSERT_TRUE(motion);
    const Pose2 truth = Pose2::exp(kHalfCircle);
    Eigen::Vector3d error;
    error << motion->start_T_end.pose.translation() - truth.translation(),
        angle_between(truth.theta(), motion->start_T_end.pose.theta());
    squares += error.dot(motion->start_T_end.covariance.inverse() * error) / kTrials;
  }
  // Three is right; what does not average out (lasting_noise) is not simulated here, which makes
  // the covariance greater than the error.
  EXPECT_GT(squares, 1.2);
  EXPECT_LT(squares, 3.3);
}

TEST(ReflectorMotion, LeavesOutAReflectorThatIsNotWhereItWas) {
  auto random = test::seeded_random();
  const ReflectorPoints hall = test::reflector_hall(10, random);
  ReflectorPoints moved = hall;
  moved[3] += Eigen::Vector2d(0.06, -0.03);
  ReflectorMotionEstimator estimator;
  for (int i = 0; i < 8; ++i) {
    estimator.add_at_start(test::seen_from(hall, {}, 0.003, random));
  }
  for (int i = 0; i < 8; ++i) {
    estimator.add_at_end(test::seen_from(moved, Pose2(0.05, 0.0, 0.02), 0.003, random));
  }
  const auto motion = estimator.result();

  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->pairs.size(), 9U);
  EXPECT_LT((Pose2(0.05, 0.0, 0.02).inverse() * motion->start_T_end.pose).log().norm(), 0.005);
}

TEST(ReflectorMotion, GoesOnByTheEncodersWhereScansAreMissing) {
  auto random = test::seeded_random();
  const ReflectorPoints hall = test::reflector_hall(10, random);
  ReflectorMotionEstimator estimator;
  for (int i = 0; i < 4; ++i) estimator.add_at_start(test::seen_from(hall, {}, 0.003, random));
  const Pose2 step(0.1, 0.0, 0.01);
  Pose2 here;
  for (int i = 0; i < 20; ++i) {
    here = here * step;
    const bool blind = i > 8 && i < 12;
    estimator.add_on_the_way(blind ? ReflectorPoints() : test::seen_from(hall, here, 0.003, random),
                             step);
  }
  for (int i = 0; i < 4; ++i) estimator.add_at_end(test::seen_from(hall, here, 0.003, random));

  EXPECT_EQ(estimator.lost_scans(), 3U);
  const auto motion = estimator.result();
  ASSERT_TRUE(motion);
  EXPECT_LT((here.inverse() * motion->start_T_end.pose).log().norm(), 0.01);
}

TEST(ReflectorMotion, SaysWhyThereIsNone) {
  auto random = test::seeded_random();
  const ReflectorMotionEstimator blind;
  EXPECT_FALSE(blind.result());
  EXPECT_EQ(blind.complaint(), "only 0 reflectors seen at both ends, of 0 in all");
  const ReflectorPoints hall = test::reflector_hall(2, random);
  const ReflectorMotionEstimator few = test::driven(hall, {1.0, 0.0, 0.1}, 0.0, random);
  EXPECT_FALSE(few.result());
  EXPECT_EQ(few.complaint(), "only 2 reflectors seen at both ends, of 2 in all");
}

TEST(ReflectorMotion, RefusesBadParameters) {
  ReflectorMotionParams params;
  params.detection_noise = 0.0;
  EXPECT_THROW(ReflectorMotionEstimator{params}, std::invalid_argument);
  params = {};
  params.min_reflectors = 1;
  EXPECT_THROW(ReflectorMotionEstimator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
