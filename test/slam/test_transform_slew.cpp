// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/transform_slew.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

const Pose2 kBase(100.0, -40.0, 0.7);  // far from the odometry's origin

TransformSlewParams slow() {
  TransformSlewParams params;
  params.max_speed = 0.5;
  params.max_turn_speed = 0.2;
  return params;
}

double distance(const Pose2& a, const Pose2& b) { return (a.inverse() * b).log().norm(); }

TEST(TransformSlew, HasNothingBeforeItIsToldAndAfterAReset) {
  TransformSlew slew;
  EXPECT_FALSE(slew.advance(1.0));
  slew.aim({1.0, 2.0, 0.5}, kBase);
  EXPECT_TRUE(slew.advance(0.0));
  slew.reset();
  EXPECT_FALSE(slew.advance(1.0));
}

TEST(TransformSlew, JumpsWithoutLimits) {
  TransformSlew slew;
  slew.aim({}, kBase);
  slew.advance(0.1);
  const Pose2 target(3.0, -2.0, 1.0);
  slew.aim(target, kBase);
  EXPECT_LT(distance(*slew.advance(0.0), target), 1e-9);
}

TEST(TransformSlew, TakesTheFirstOneAtOnce) {
  TransformSlew slew(slow());
  const Pose2 target(3.0, -2.0, 1.0);
  slew.aim(target, kBase);
  EXPECT_LT(distance(*slew.advance(0.0), target), 1e-9);
}

TEST(TransformSlew, MovesTheVehicleNoFasterThanAllowedAndArrives) {
  TransformSlew slew(slow());
  slew.aim({}, kBase);
  Pose2 last = *slew.advance(0.0) * kBase;
  const Pose2 target(0.8, 0.3, 0.1);  // moves the base by metres
  slew.aim(target, kBase);
  constexpr double kSeconds = 0.05;
  int steps = 0;
  Pose2 now = last;
  for (; distance(now, target * kBase) > 1e-9 && steps < 10000; ++steps) {
    now = *slew.advance(kSeconds) * kBase;
    const Pose2 step = last.inverse() * now;
    EXPECT_LE(step.translation().norm(), 0.5 * kSeconds + 1e-9);
    EXPECT_LE(std::abs(step.theta()), 0.2 * kSeconds + 1e-9);
    last = now;
  }
  const double way = (kBase.inverse() * target * kBase).translation().norm();
  EXPECT_NEAR(steps * kSeconds, way / 0.5, 0.1);
}

TEST(TransformSlew, TurnsTheShortWay) {
  TransformSlew slew(slow());
  slew.aim({0.0, 0.0, kPi - 0.05}, {});
  slew.advance(0.0);
  slew.aim({0.0, 0.0, -kPi + 0.05}, {});
  EXPECT_NEAR(wrap_angle(slew.advance(0.25)->theta() - kPi), 0.0, 1e-9);
  EXPECT_NEAR(slew.advance(10.0)->theta(), -kPi + 0.05, 1e-12);
}

TEST(TransformSlew, StandsStillWithoutTime) {
  TransformSlew slew(slow());
  slew.aim({}, kBase);
  slew.advance(0.0);
  slew.aim({1.0, 0.0, 0.0}, kBase);
  EXPECT_LT(distance(*slew.advance(0.0), {}), 1e-12);
  EXPECT_LT(distance(*slew.advance(-5.0), {}), 1e-12);
}

TEST(TransformSlewParams, AreValidated) {
  TransformSlewParams params;
  params.max_turn_speed = -1.0;
  EXPECT_THROW(TransformSlew{params}, std::invalid_argument);
  params.max_turn_speed = std::nan("");
  EXPECT_THROW(TransformSlew{params}, std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
