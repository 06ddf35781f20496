// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/pose_estimate.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

Eigen::Vector3d coordinates(const Pose2& pose) { return {pose.x(), pose.y(), pose.theta()}; }

Pose2 shifted(const Pose2& pose, const Eigen::Vector3d& by) {
  return {pose.x() + by.x(), pose.y() + by.y(), pose.theta() + by.z()};
}

Eigen::Matrix3d numeric_jacobian(const std::function<Pose2(const Eigen::Vector3d&)>& function) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix3d jacobian;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    Eigen::Vector3d change = coordinates(function(step)) - coordinates(function(-step));
    change.z() = wrap_angle(change.z());
    jacobian.col(i) = change / (2.0 * kStep);
  }
  return jacobian;
}

TEST(ComposeJacobians, AreTheDerivatives) {
  for (const Pose2& a : {Pose2(1.0, 2.0, 0.7), Pose2(-3.0, 0.5, kPi - 1e-9)}) {
    for (const Pose2& b : {Pose2(0.2, -0.4, -2.0), Pose2(5.0, 1.0, 0.0)}) {
      const auto [dleft, dright] = compose_jacobians(a, b);
      EXPECT_TRUE(dleft.isApprox(
          numeric_jacobian([&](const Eigen::Vector3d& d) { return shifted(a, d) * b; }), 1e-7));
      EXPECT_TRUE(dright.isApprox(
          numeric_jacobian([&](const Eigen::Vector3d& d) { return a * shifted(b, d); }), 1e-7));
    }
  }
}

TEST(InverseJacobian, IsTheDerivative) {
  for (const Pose2& pose : {Pose2(1.0, 2.0, 0.7), Pose2(-3.0, 0.5, -3.0), Pose2()}) {
    EXPECT_TRUE(inverse_jacobian(pose).isApprox(
        numeric_jacobian([&](const Eigen::Vector3d& d) { return shifted(pose, d).inverse(); }),
        1e-7));
  }
}

// The covariance of a sample of errors must be the propagated one.
TEST(Compose, CovarianceIsThatOfSamples) {
  auto random = test::seeded_random();
  const Eigen::Vector3d sigma_a(0.02, 0.01, 0.005);
  const Eigen::Vector3d sigma_b(0.01, 0.03, 0.002);
  const PoseEstimate a{{2.0, 1.0, 1.1}, sigma_a.array().square().matrix().asDiagonal()};
  const PoseEstimate b{{4.0, -1.0, 0.3}, sigma_b.array().square().matrix().asDiagonal()};
  const auto error = [&](const Eigen::Vector3d& sigma) {
    return Eigen::Vector3d(test::normal(random, sigma.x()), test::normal(random, sigma.y()),
                           test::normal(random, sigma.z()));
  };

  constexpr int kSamples = 20000;
  const PoseEstimate c = compose(a, b);
  Eigen::Matrix3d sample = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kSamples; ++i) {
    const Pose2 pose = shifted(a.pose, error(sigma_a)) * shifted(b.pose, error(sigma_b));
    const Eigen::Vector3d off = coordinates(pose) - coordinates(c.pose);
    sample += off * off.transpose() / kSamples;
  }

  EXPECT_TRUE(sample.isApprox(c.covariance, 0.03)) << sample << "\n\n" << c.covariance;
}

TEST(Inverse, TwiceIsTheSame) {
  Eigen::Matrix3d covariance;
  covariance << 4e-4, 1e-5, 2e-5, 1e-5, 1e-4, -1e-5, 2e-5, -1e-5, 9e-5;
  const PoseEstimate a{{2.0, 1.0, 1.1}, covariance};
  const PoseEstimate twice = inverse(inverse(a));
  EXPECT_TRUE(twice.covariance.isApprox(covariance, 1e-12));
  EXPECT_NEAR(twice.pose.x(), a.pose.x(), 1e-12);
}

TEST(Transform, TurnsThePointsCovarianceAndAddsThePoses) {
  PoseEstimate a{{0.0, 0.0, kPi / 2.0}, Eigen::Matrix3d::Zero()};
  a.covariance(2, 2) = 1e-4;
  const PointEstimate point{{2.0, 0.0}, Eigen::Vector2d(9e-4, 1e-4).asDiagonal()};

  const PointEstimate result = transform(a, point);

  EXPECT_TRUE(result.point.isApprox(Eigen::Vector2d(0.0, 2.0), 1e-12));
  EXPECT_NEAR(result.covariance(0, 0), 1e-4 + 4.0 * 1e-4, 1e-12);  // across: heading over 2 m
  EXPECT_NEAR(result.covariance(1, 1), 9e-4, 1e-12);
  EXPECT_NEAR(result.covariance(0, 1), 0.0, 1e-12);
}

}  // namespace
}  // namespace falko_slam
