// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_agreement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

ScanView view_of(const Scene& scene, const Pose2& world_T_laser, std::mt19937_64& random,
                 double noise = 0.01, std::size_t beams = 720) {
  return ScanView(test::closed_scan(scene, world_T_laser, beams, noise, random));
}

Scene corridor() {
  Scene scene;
  scene.walls = {{{-500.0, 1.5}, {500.0, 1.5}}, {{-500.0, -1.5}, {500.0, -1.5}}};
  return scene;
}

Scene square_room() {
  Scene scene;
  scene.add_box({}, {6.0, 6.0});
  return scene;
}

void expect_near(const Pose2& a, const Pose2& b, double distance, double degrees) {
  const Pose2 difference = a.inverse() * b;
  EXPECT_LT(difference.translation().norm(), distance) << a << " and " << b;
  EXPECT_LT(std::abs(difference.theta()), degrees_to_radians(degrees)) << a << " and " << b;
}

TEST(ScanAgreement, AScanAgreesWithItself) {
  auto random = test::seeded_random();
  const ScanView view = view_of(test::room_with_pillar(), {}, random);
  const Agreement self = agreement(view, view, {});
  EXPECT_EQ(self.points, view.points().size());
  EXPECT_EQ(self.agreeing, self.points);
  EXPECT_EQ(self.agreeing_length, self.length);
  EXPECT_EQ(self.ratio(), 1.0);
}

TEST(ScanAgreement, TakesEveryStridethPoint) {
  auto random = test::seeded_random();
  const ScanView view = view_of(test::room_with_pillar(), {}, random);
  for (const std::size_t stride : {1U, 2U, 5U}) {
    EXPECT_EQ(agreement(view, view, {}, {}, stride).points,
              (view.points().size() + stride - 1) / stride);
  }
}

TEST(ScanAgreement, EveryPointCountsAtMostOnce) {
  auto random = test::seeded_random();
  const ScanView target = view_of(test::room_with_pillar(), {}, random);
  for (int run = 0; run < 50; ++run) {
    const Pose2 pose(test::uniform(random, -3.0, 3.0), test::uniform(random, -3.0, 3.0),
                     test::uniform(random, -kPi, kPi));
    const Agreement found = agreement(target, target, pose);
    EXPECT_LE(found.seen(), found.points);
    EXPECT_LE(found.agreeing_length + found.missed_length + found.seen_through_length,
              found.length + 1e-9);
    EXPECT_GE(found.ratio(), 0.0);
    EXPECT_LE(found.ratio(), 1.0);
  }
}

// A wall before the laser, `distance` away; the other scan saw one at 4 m.
Agreement wall_at(double distance) {
  const auto wall = [](double x) {
    Scene scene;
    scene.walls = {{{x, -0.2 * x}, {x, 0.2 * x}}};
    auto random = test::seeded_random();
    return view_of(scene, {}, random, 0.0);
  };
  return agreement(wall(4.0), wall(distance), {});
}

TEST(ScanAgreement, AWallInFrontOfWhatWasSeenIsSeenThrough) {
  const Agreement found = wall_at(2.0);
  EXPECT_GT(found.points, 0U);
  EXPECT_EQ(found.seen_through, found.points);
  EXPECT_EQ(found.ratio(), 0.0);
}

TEST(ScanAgreement, AWallBehindWhatWasSeenSaysNothing) {
  const Agreement found = wall_at(6.0);
  EXPECT_GT(found.points, 0U);
  EXPECT_EQ(found.seen(), 0U);
}

TEST(ScanAgreement, AWallBesideWhatWasSeenIsMissed) {
  for (const double distance : {3.8, 4.2}) {
    const Agreement found = wall_at(distance);
    EXPECT_GT(found.missed, 0U);
    EXPECT_EQ(found.missed, found.points) << distance;
  }
}

TEST(ScanAgreement, InvalidBeamsSayNothing) {
  auto random = test::seeded_random();
  const ScanView view = view_of(square_room(), {}, random);
  const ScanView blind(test::round_scan(test::kNoRange));
  EXPECT_EQ(agreement(blind, view, {}).seen(), 0U);
  EXPECT_EQ(agreement(blind, view, {}).points, view.points().size());
}

TEST(ScanAgreement, EmptyViewsAgreeInNothing) {
  auto random = test::seeded_random();
  const ScanView view = view_of(square_room(), {}, random);
  EXPECT_EQ(agreement(ScanView(), view, {}).seen(), 0U);
  EXPECT_EQ(agreement(view, ScanView(), {}).points, 0U);
  EXPECT_EQ(agreement(view, ScanView(), {}).ratio(), 0.0);
  EXPECT_FALSE(register_scans(ScanView(), view, {}));
  EXPECT_FALSE(register_scans(view, ScanView(), {}));
  EXPECT_FALSE(register_scans(ScanView(), ScanView(), {}));
}

TEST(RegisterScans, FindsThePoseFromNearIt) {
  auto random = test::seeded_random();
  for (int run = 0; run < 20; ++run) {
    const Pose2 pose(test::uniform(random, -0.5, 0.5), test::uniform(random, -0.5, 0.5),
                     test::uniform(random, -kPi, kPi));
    const ScanView target = view_of(test::room_with_pillar(), {}, random);
    const ScanView source = view_of(test::room_with_pillar(), pose, random);
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
  const ScanView target = view_of(test::room_with_pillar(), {}, random);
  const ScanView source = view_of(test::room_with_pillar(), pose, random);
  const auto forward = register_scans(target, source, pose);
  const auto backward = register_scans(source, target, pose.inverse());
  ASSERT_TRUE(forward && backward);
  expect_near(backward->target_T_source.pose, forward->target_T_source.pose.inverse(), 0.005, 0.2);
}

TEST(RegisterScans, KnowsThatACorridorIsOpenAlongItself) {
  auto random = test::seeded_random();
  for (const std::size_t beams : {360U, 720U, 1440U}) {
    const ScanView target = view_of(corridor(), {}, random, 0.01, beams);
    const ScanView source = view_of(corridor(), {0.4, 0.2, 0.1}, random, 0.01, beams);
    const auto found = register_scans(target, source, {0.4, 0.2, 0.1});
    // 0.1 is where scan_score() starts to count a direction as open.
    EXPECT_LT(found ? found->constraint : 0.0, 0.1) << beams;
    const ScanView exact = view_of(corridor(), {}, random, 0.0, beams);
    EXPECT_FALSE(register_scans(exact, exact, {})) << beams;
  }
}

TEST(RegisterScans, ASquareRoomHoldsAllDirectionsAlike) {
  auto random = test::seeded_random();
  const ScanView target = view_of(square_room(), {}, random);
  const auto found = register_scans(target, view_of(square_room(), {}, random), {});
  ASSERT_TRUE(found);
  EXPECT_GT(found->constraint, 0.9);
  EXPECT_LE(found->constraint, 1.0);
}

TEST(RegisterScans, ASurerScanHasASmallerCovariance) {
  auto random = test::seeded_random();
  const auto trace = [&](double noise) {
    const ScanView target = view_of(test::room_with_pillar(), {}, random, noise);
    const ScanView source = view_of(test::room_with_pillar(), {}, random, noise);
    const auto found = register_scans(target, source, {});
    return found ? found->target_T_source.covariance.trace() : -1.0;
  };
  const double sure = trace(0.005);
  EXPECT_GT(sure, 0.0);
  EXPECT_GT(trace(0.02), sure);
}

TEST(AgreementParams, NamesFieldAndValueOfWhatIsWrong) {
  const auto error_of = [](const auto& params) {
    try {
      validate(params);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  AgreementParams agreement;
  agreement.tolerance = 0.0;
  EXPECT_EQ(error_of(agreement).find("tolerance = 0: "), 0U);
  RegistrationParams registration;
  registration.last_gate = std::nan("");
  EXPECT_EQ(error_of(registration).find("last_gate = nan: "), 0U);
}

}  // namespace
}  // namespace falko_slam
