// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/pose_graph.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

Eigen::Matrix3d random_covariance(std::mt19937_64& random) {
  Eigen::Matrix3d root;
  for (int i = 0; i < 9; ++i) root(i) = test::normal(random, 0.1);
  return root * root.transpose() + 1e-4 * Eigen::Matrix3d::Identity();
}

TEST(PoseGraph, TakesACovarianceOfTheOtherFrameAndGivesItBack) {
  auto random = test::seeded_random();
  for (int run = 0; run < 20; ++run) {
    const PoseEstimate estimate{Pose2(2.0, -1.0, test::uniform(random, -4.0, 4.0)),
                                random_covariance(random)};

    const PoseEstimate back =
        estimate_of(constraint_between({0}, {1}, estimate, ConstraintKind::kClosure));

    EXPECT_LT((back.covariance - estimate.covariance).norm(), 1e-9);
  }
}

// The covariance of the residual, by its numeric derivatives with respect to what was measured.
TEST(PoseGraph, StatesTheInformationOfItsResidual) {
  auto random = test::seeded_random();
  const PoseEstimate estimate{Pose2(2.0, -1.0, 2.2), random_covariance(random)};
  const GraphConstraint constraint =
      constraint_between({0}, {1}, estimate, ConstraintKind::kOdometry);
  const Pose2 from(4.0, 5.0, -2.0), to = from * estimate.pose;
  constexpr double kStep = 1e-6;
  Eigen::Matrix3d derivative;
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    step(i) = kStep;
    GraphConstraint shifted = constraint;
    shifted.from_T_to =
        Pose2(estimate.pose.translation() + step.head<2>(), estimate.pose.theta() + step.z());
    derivative.col(i) = residual_of(shifted, from, to) / kStep;
  }

  const Eigen::Matrix3d covariance = derivative * estimate.covariance * derivative.transpose();

  EXPECT_LT((covariance * constraint.information - Eigen::Matrix3d::Identity()).norm(), 1e-4);
}

TEST(PoseGraph, WrapsTheAngleOfItsResidual) {
  for (const double left : {0.0, 1e-9, -1e-9, kPi - 1e-9, 1e-9 - kPi}) {
    const GraphConstraint constraint{{0}, {1}, Pose2(1.0, 0.0, 3.0)};
    const Pose2 from(0.0, 0.0, 2.0);
    const Eigen::Vector3d residual =
        residual_of(constraint, from, from * Pose2(1.0, 0.0, 3.0 + left + kTwoPi));
    EXPECT_NEAR(residual.z(), left, 1e-14);
    EXPECT_LT(residual.head<2>().norm(), 1e-14);
  }
}

TEST(PoseGraph, TakesTheRootOfSemidefiniteInformation) {
  auto random = test::seeded_random();
  for (int rank = 0; rank <= 3; ++rank) {
    Eigen::Matrix3d factor = Eigen::Matrix3d::Zero();
    for (int i = 0; i < rank; ++i) {
      for (int j = 0; j < 3; ++j) factor(i, j) = test::normal(random, 10.0);
    }
    const Eigen::Matrix3d information = factor.transpose() * factor;
    const Eigen::Matrix3d root = square_root_of_information(information);
    EXPECT_LT((root.transpose() * root - information).norm(), 1e-9 * (1.0 + information.norm()));
  }
}

TEST(PoseGraph, RefusesACovarianceThatIsNone) {
  PoseEstimate estimate;
  EXPECT_THROW(constraint_between({0}, {1}, estimate, ConstraintKind::kClosure),
               std::invalid_argument);
  estimate.covariance = Eigen::Vector3d(1.0, -1.0, 1.0).asDiagonal();
  EXPECT_THROW(constraint_between({0}, {1}, estimate, ConstraintKind::kClosure),
               std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
