// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/scan_link.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "support/scan_views.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

PoseEstimate guess(const Pose2& pose, double distance = 0.2, double turn = 0.1) {
  return {pose,
          Eigen::Vector3d(distance * distance, distance * distance, turn * turn).asDiagonal()};
}

TEST(LinkScans, FindsThePoseAndIsSureOfIt) {
  auto random = test::seeded_random();
  const Pose2 truth(0.5, -0.2, 0.4);
  const ScanView target = test::view_of(test::room_with_pillar(), {}, random);
  const ScanView source = test::view_of(test::room_with_pillar(), truth, random);
  const auto link = link_scans(target, source, guess(truth * Pose2(0.1, -0.1, 0.05)));
  ASSERT_TRUE(link);
  const Pose2 error = truth.inverse() * link->target_T_source.pose;
  EXPECT_LT(error.translation().norm(), 0.01);
  EXPECT_LT(std::abs(error.theta()), 0.005);
  EXPECT_GT(link->agreement, 0.9);
  EXPECT_LT(link->target_T_source.covariance.diagonal().maxCoeff(), 0.02 * 0.02);
}

// However firm the guess: the scans alone say how sure the link is.
TEST(LinkScans, IsAsUnsureAlongACorridorAsIfItWereAnywhere) {
  auto random = test::seeded_random();
  Scene corridor;
  corridor.walls = {{{-500.0, 1.5}, {500.0, 1.5}}, {{-500.0, -1.5}, {500.0, -1.5}}};
  const Pose2 truth(0.5, 0.1, 0.05);
  const ScanView target = test::view_of(corridor, {}, random);
  const ScanView source = test::view_of(corridor, truth, random);
  for (const double firm : {0.2, 0.05, 0.01}) {
    const auto link = link_scans(target, source, guess(truth, firm));
    ASSERT_TRUE(link) << firm;
    const Eigen::Matrix3d& covariance = link->target_T_source.covariance;
    EXPECT_GT(std::sqrt(covariance(0, 0)), 0.3) << firm;
    EXPECT_LT(std::sqrt(covariance(1, 1)), 0.02) << firm;
    EXPECT_LT(std::sqrt(covariance(2, 2)), 0.01) << firm;
    EXPECT_NEAR(link->target_T_source.pose.y(), truth.y(), 0.02) << firm;
  }
}

TEST(LinkScans, RefusesScansThatDisagree) {
  auto random = test::seeded_random();
  Scene elsewhere;
  elsewhere.add_box({0.4, 0.3, 0.7}, {3.0, 1.8});
  const ScanView room = test::view_of(test::room_with_pillar(), {}, random);
  const ScanView other = test::view_of(elsewhere, {}, random);
  EXPECT_FALSE(link_scans(room, other, guess({})));
  EXPECT_FALSE(link_scans(other, room, guess({})));
  EXPECT_FALSE(link_scans(room, ScanView(), guess({})));
  EXPECT_FALSE(link_scans(ScanView(), room, guess({})));
}

TEST(LinkScans, RefusesToMoveFarFromTheGuess) {
  auto random = test::seeded_random();
  const ScanView room = test::view_of(test::room_with_pillar(), {}, random);
  ScanLinkParams params;
  params.max_move = 0.02;
  EXPECT_TRUE(link_scans(room, room, guess({0.01, 0.0, 0.0}), params));
  EXPECT_FALSE(link_scans(room, room, guess({0.1, 0.0, 0.0}), params));
}

TEST(LinkScans, TheErrorIsAsGreatAsItsCovarianceSays) {
  auto random = test::seeded_random();
  constexpr int kRuns = 200;
  double sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const Pose2 at(test::uniform(random, -0.5, 0.5), test::uniform(random, -0.5, 0.5),
                   test::uniform(random, -kPi, kPi));
    const Pose2 truth(test::uniform(random, -0.3, 0.3), test::uniform(random, -0.3, 0.3),
                      test::uniform(random, -0.5, 0.5));
    const auto link =
        link_scans(test::view_of(test::room_with_pillar(), at, random, 0.02, 360),
                   test::view_of(test::room_with_pillar(), at * truth, random, 0.02, 360),
                   guess(truth * Pose2(0.05, -0.05, 0.02)));
    ASSERT_TRUE(link);
    const Pose2& pose = link->target_T_source.pose;
    const Eigen::Vector3d error(pose.x() - truth.x(), pose.y() - truth.y(),
                                angle_between(truth.theta(), pose.theta()));
    sum += error.dot(link->target_T_source.covariance.inverse() * error);
  }
  EXPECT_GT(sum / kRuns, 0.5);
  EXPECT_LT(sum / kRuns, 3.6);
}

TEST(ScanLinkParams, NamesFieldAndValueOfWhatIsWrong) {
  ScanLinkParams params;
  params.min_view = 2.0;
  try {
    validate(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("min_view = 2"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
