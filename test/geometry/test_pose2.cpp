// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/pose2.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "support/poses.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// Poses with every nasty heading, and random ones.
std::vector<Pose2> poses() {
  std::vector<Pose2> list;
  for (const double theta :
       {0.0, 1e-9, -1e-9, 1e-5, kPi, -kPi, kPi - 1e-9, -kPi + 1e-9, 3.0 * kPi}) {
    list.emplace_back(1.5, -0.7, theta);
  }
  auto random = test::seeded_random();
  for (int i = 0; i < 20; ++i) {
    list.emplace_back(test::uniform(random, -9.0, 9.0), test::uniform(random, -9.0, 9.0),
                      test::uniform(random, -kPi, kPi));
  }
  return list;
}

TEST(Pose2, IsAGroup) {
  const Pose2 identity;
  for (const Pose2& a : poses()) {
    test::expect_near(a * identity, a, 1e-12);
    test::expect_near(identity * a, a, 1e-12);
    test::expect_near(a * a.inverse(), identity, 1e-12);
    test::expect_near(a.inverse() * a, identity, 1e-12);
    for (const Pose2& b : poses()) {
      test::expect_near((a * b).inverse(), b.inverse() * a.inverse(), 1e-11);
      for (const Pose2& c : {Pose2(0.3, 4.0, 2.0), Pose2(-2.0, 0.1, -3.0)}) {
        test::expect_near((a * b) * c, a * (b * c), 1e-11);
      }
    }
  }
}

TEST(Pose2, ActsOnPointsAsItComposes) {
  const Eigen::Vector2d point(0.4, -1.3);
  for (const Pose2& a : poses()) {
    for (const Pose2& b : poses()) {
      EXPECT_TRUE(((a * b) * point).isApprox(a * (b * point), 1e-12));
    }
    EXPECT_TRUE((a * point).isApprox(a.rotation() * point + a.translation(), 1e-14));
  }
}

TEST(Pose2, ExpIsTheInverseOfLog) {
  for (const Pose2& pose : poses()) test::expect_near(Pose2::exp(pose.log()), pose, 1e-12);
  for (const Eigen::Vector3d& tangent :
       {Eigen::Vector3d(0.5, -0.2, 0.0), Eigen::Vector3d(1.0, 2.0, 1e-9),
        Eigen::Vector3d(1.0, 2.0, -1e-4), Eigen::Vector3d(-3.0, 0.4, kPi - 1e-6)}) {
    EXPECT_TRUE(Pose2::exp(tangent).log().isApprox(tangent, 1e-9)) << tangent.transpose();
  }
}

TEST(Pose2, ExpFollowsTheArc) {
  // A quarter of a circle of radius 2 m, travelled at constant velocity.
  const Pose2 pose = Pose2::exp({2.0 * kPi / 2.0, 0.0, kPi / 2.0});
  test::expect_near(pose, Pose2(2.0, 2.0, kPi / 2.0), 1e-12);
}

TEST(Pose2, ExpIsSmoothThroughZero) {
  const Eigen::Vector3d tangent(1.0, 1.0, 0.0);
  for (const double theta : {1e-3, 1e-4, 1.0001e-4, 0.9999e-4, 1e-8}) {
    // Second order expansion; what is left out is below theta^2.
    const Pose2 pose = Pose2::exp({tangent.x(), tangent.y(), theta});
    EXPECT_NEAR(pose.x(), 1.0 - 0.5 * theta, theta * theta);
    EXPECT_NEAR(pose.y(), 1.0 + 0.5 * theta, theta * theta);
  }
}

TEST(Pose2, AdjointMovesTangentsToTheOtherSide) {
  const Eigen::Vector3d tangent(0.3, -0.2, 0.4);
  for (const Pose2& pose : poses()) {
    test::expect_near(pose * Pose2::exp(tangent) * pose.inverse(),
                      Pose2::exp(pose.adjoint() * tangent), 1e-11);
  }
}

TEST(Pose2, PrintsItsUnits) {
  std::ostringstream text;
  text << Pose2(1.0, 2.0, 0.5);
  EXPECT_EQ(text.str(), "(1 m, 2 m, 0.5 rad)");
}

}  // namespace
}  // namespace falko_slam
