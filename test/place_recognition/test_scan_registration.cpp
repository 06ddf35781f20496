// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_registration.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

#include "support/scan_views.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

Scene corridor() {
  Scene scene;
  scene.walls = {{{-500.0, 1.5}, {500.0, 1.5}}, {{-500.0, -1.5}, {500.0, -1.5}}};
  return scene;
}

void expect_near(const Pose2& a, const Pose2& b, double distance, double degrees) {
  const Pose2 difference = a.inverse() * b;
  EXPECT_LT(difference.translation().norm(), distance) << a << " and " << b;
  EXPECT_LT(std::abs(difference.theta()), degrees_to_radians(degrees)) << a << " and " << b;
}

TEST(RegisterScans, EmptyViewsCannotBeAligned) {
  auto random = test::seeded_random();
  const ScanView view = test::view_of(test::square_room(), {}, random);
  EXPECT_FALSE(register_scans(ScanView(), view, {}));
  EXPECT_FALSE(register_scans(view, ScanView(), {}));
  EXPECT_FALSE(register_scans(ScanView(), ScanView(), {}));
}

TEST(RegisterScans, FindsThePoseFromNearIt) {
  auto random = test::seeded_random();
  for (int run = 0; run < 20; ++run) {
    const Pose2 pose(test::uniform(random, -0.5, 0.5), test::uniform(random, -0.5, 0.5),
                     test::uniform(random, -kPi, kPi));
    const ScanView target = test::view_of(test::room_with_pillar(), {}, random);
    const ScanView source = test::view_of(test::room_with_pillar(), pose, random);
    const double way = test::uniform(random, -kPi, kPi);
    const double turn = degrees_to_radians(run % 2 == 0 ? 5.0 : -5.0);
    const Pose2 start(pose.translation() + 0.2 * Eigen::Vector2d(std::cos(way), std::sin(way)),
                      pose.theta() + turn);
    const auto found = register_scans(target, source, start);
    ASSERT_TRUE(found);
    expect_near(found->target_T_source.pose, pose, 0.005, 0.2);
  }
}

TEST(RegisterScans, SwappedScansGiveTheInverse) {
  auto random = test::seeded_random();
  const Pose2 pose(0.4, -0.3, 0.6);
  const ScanView target = test::view_of(test::room_with_pillar(), {}, random);
  const ScanView source = test::view_of(test::room_with_pillar(), pose, random);
  const auto forward = register_scans(target, source, pose);
  const auto backward = register_scans(source, target, pose.inverse());
  ASSERT_TRUE(forward && backward);
  expect_near(backward->target_T_source.pose, forward->target_T_source.pose.inverse(), 0.005, 0.2);
}

TEST(RegisterScans, KnowsThatACorridorIsOpenAlongItself) {
  auto random = test::seeded_random();
  for (const std::size_t beams : {360U, 720U, 1440U}) {
    const ScanView target = test::view_of(corridor(), {}, random, 0.01, beams);
    const ScanView source = test::view_of(corridor(), {0.4, 0.2, 0.1}, random, 0.01, beams);
    const auto found = register_scans(target, source, {0.4, 0.2, 0.1});
    // 0.1 is where scan_score() starts to count a direction as open.
    EXPECT_LT(found ? found->constraint : 0.0, 0.1) << beams;
    const ScanView exact = test::view_of(corridor(), {}, random, 0.0, beams);
    EXPECT_FALSE(register_scans(exact, exact, {})) << beams;
  }
}

// The noise of the normals alone would hold the scan to within 2 cm along the corridor.
TEST(RegisterScan, FollowsThePriorAlongACorridor) {
  auto random = test::seeded_random();
  const Pose2 truth(0.5, 0.1, 0.05);
  const Pose2 start = Pose2(0.1, 0.0, 0.0) * truth;
  const Eigen::Matrix3d prior = Eigen::Vector3d(100.0, 100.0, 100.0).asDiagonal();
  double mean = 0.0;
  constexpr int kRuns = 50;
  for (int run = 0; run < kRuns; ++run) {
    const ScanView target = test::view_of(corridor(), {}, random, 0.02, 720);
    const ScanView source = test::view_of(corridor(), truth, random, 0.02, 720);
    const auto found = register_scan({{&target, Pose2()}}, source, start, {}, prior);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->target_T_source.pose.y(), truth.y(), 0.02);
    EXPECT_NEAR(found->target_T_source.pose.theta(), truth.theta(), 0.01);
    mean += (found->target_T_source.pose.x() - start.x()) / kRuns;
  }
  EXPECT_NEAR(mean, 0.0, 0.02);
}

TEST(RegisterScan, ScansOfTheTargetLieWhereTheyWereTaken) {
  auto random = test::seeded_random();
  const Pose2 elsewhere(20.0, -7.0, 2.0);
  const Pose2 second(0.4, -0.2, 0.3);
  const Pose2 truth(0.2, 0.3, -0.2);
  const ScanView a = test::view_of(test::room_with_pillar(), {}, random);
  const ScanView b = test::view_of(test::room_with_pillar(), second, random);
  const ScanView source = test::view_of(test::room_with_pillar(), truth, random);
  const auto found = register_scan({{&a, elsewhere}, {&b, elsewhere * second}}, source,
                                   elsewhere * truth * Pose2(0.05, 0.05, 0.02), {});
  ASSERT_TRUE(found);
  expect_near(found->target_T_source.pose, elsewhere * truth, 0.005, 0.2);
}

TEST(RegisterScan, AFirmPriorIsKept) {
  auto random = test::seeded_random();
  const ScanView view = test::view_of(test::square_room(), {}, random);
  const Pose2 start(0.05, 0.02, 0.01);
  const auto found = register_scan({{&view, Pose2()}}, view, start, {},
                                   Eigen::Matrix3d(1e9 * Eigen::Matrix3d::Identity()));
  ASSERT_TRUE(found);
  expect_near(found->target_T_source.pose, start, 1e-3, 0.1);
}

TEST(RegisterScans, ASquareRoomHoldsAllDirectionsAlike) {
  auto random = test::seeded_random();
  const ScanView target = test::view_of(test::square_room(), {}, random);
  const auto found = register_scans(target, test::view_of(test::square_room(), {}, random), {});
  ASSERT_TRUE(found);
  EXPECT_GT(found->constraint, 0.9);
  EXPECT_LE(found->constraint, 1.0);
}

TEST(RegisterScans, ASurerScanHasASmallerCovariance) {
  auto random = test::seeded_random();
  const auto trace = [&](double noise) {
    const ScanView target = test::view_of(test::room_with_pillar(), {}, random, noise);
    const ScanView source = test::view_of(test::room_with_pillar(), {}, random, noise);
    const auto found = register_scans(target, source, {});
    return found ? found->target_T_source.covariance.trace() : -1.0;
  };
  const double sure = trace(0.005);
  EXPECT_GT(sure, 0.0);
  EXPECT_GT(trace(0.02), sure);
}

// The mean square of the error in standard deviations (NEES) of 3 degrees of freedom is 3.
TEST(RegisterScans, TheErrorIsAsGreatAsItsCovarianceSays) {
  auto random = test::seeded_random();
  const Scene room = test::room_with_pillar();
  constexpr int kRuns = 100;
  for (const double noise : {0.005, 0.01, 0.03}) {
    for (const std::size_t beams : {180U, 360U, 720U, 1440U}) {
      double sum = 0.0;
      for (int run = 0; run < kRuns; ++run) {
        const Pose2 target(test::uniform(random, -0.5, 0.5), test::uniform(random, -0.5, 0.5),
                           test::uniform(random, -kPi, kPi));
        const Pose2 truth(test::uniform(random, -0.3, 0.3), test::uniform(random, -0.3, 0.3),
                          test::uniform(random, -0.5, 0.5));
        const auto found = register_scans(test::view_of(room, target, random, noise, beams),
                                          test::view_of(room, target * truth, random, noise, beams),
                                          truth * Pose2(0.05, -0.05, 0.02));
        ASSERT_TRUE(found);
        const Pose2& pose = found->target_T_source.pose;
        const Eigen::Vector3d error(pose.x() - truth.x(), pose.y() - truth.y(),
                                    angle_between(truth.theta(), pose.theta()));
        sum += error.dot(found->target_T_source.covariance.inverse() * error);
      }
      EXPECT_GT(sum / kRuns, 1.8) << noise << ", " << beams;
      EXPECT_LT(sum / kRuns, 5.0) << noise << ", " << beams;
    }
  }
}

TEST(RegisterScans, AnyNumberOfIterationsGivesAResult) {
  auto random = test::seeded_random();
  const ScanView view = test::view_of(test::room_with_pillar(), {}, random);
  for (const int iterations : {1, 2, 3, 20}) {
    RegistrationParams params;
    params.iterations = iterations;
    const auto found = register_scans(view, view, {}, params);
    ASSERT_TRUE(found) << iterations;
    EXPECT_GT(found->target_T_source.covariance.trace(), -1e-300);
    EXPECT_GT(found->constraint, 0.1) << iterations;
  }
}

TEST(RegistrationParams, NamesFieldAndValueOfWhatIsWrong) {
  RegistrationParams params;
  params.last_gate = std::nan("");
  try {
    validate(params);
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("last_gate = nan: "), 0U) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
