// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "falko_slam/geometry/angles.hpp"
#include "support/poses.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

constexpr std::uint32_t kStart = 4294967000U;  // soon over its end

TricycleParams vehicle() { return {1.4, 2.5e-4, 0.01, -0.02}; }

EncoderParams encoders() {
  EncoderParams params;
  params.steer_ticks_per_turn = 8192;
  params.steer_zero = 77;
  return params;
}

// The counters of a wheel that has turned `ticks` since kStart, and looks to `steering`.
EncoderReading reading_of(int milliseconds, int ticks, double steering) {
  return {Time(std::chrono::milliseconds(milliseconds)), kStart + static_cast<std::uint32_t>(ticks),
          steer_ticks_of(encoders(), steering)};
}

double measured(double steering) {
  return steering_of(encoders(), steer_ticks_of(encoders(), steering));
}

TEST(TricycleOdometry, BeginsWhereItIsTold) {
  const Pose2 start(1.0, 2.0, 0.5);
  TricycleOdometry odometry(vehicle(), encoders(), start);
  EXPECT_FALSE(odometry.reading());
  EXPECT_EQ(odometry.add(reading_of(0, 123456, 0.3)).verdict, OdometryVerdict::kFirst);
  test::expect_near(odometry.odom_T_base(), start, 0.0);
  EXPECT_EQ(odometry.velocity().forward, 0.0);
  EXPECT_EQ(odometry.velocity().turn_rate, 0.0);
  EXPECT_TRUE(odometry.reading());
}

TEST(TricycleOdometry, AddsArcsOverTheEndOfTheCounter) {
  const Pose2 start(1.0, 2.0, 0.5);
  TricycleOdometry odometry(vehicle(), encoders(), start);
  Pose2 expected = start;
  odometry.add(reading_of(0, 0, 0.3));
  for (int i = 1; i <= 20; ++i) {
    const OdometryStep step = odometry.add(reading_of(20 * i, 100 * i, 0.3));
    EXPECT_EQ(step.verdict, OdometryVerdict::kIntegrated);
    EXPECT_EQ(step.ticks, 100);
    EXPECT_EQ(step.time, std::chrono::milliseconds(20));
    expected = expected * drive_arc(vehicle(), 100.0, measured(0.3));
  }
  test::expect_near(odometry.odom_T_base(), expected, 1e-12);
  test::expect_near(odometry.odom_T_base(), start * drive_arc(vehicle(), 2000.0, measured(0.3)),
                    1e-12);
}

TEST(TricycleOdometry, DrivesBackwardWithTheOffsetOfThatDirection) {
  TricycleOdometry odometry(vehicle(), encoders());
  odometry.add(reading_of(0, 1000, -0.2));
  odometry.add(reading_of(500, -1000, -0.2));
  test::expect_near(odometry.odom_T_base(), drive_arc(vehicle(), -2000.0, measured(-0.2)), 1e-12);
  EXPECT_LT(odometry.velocity().forward, 0.0);
}

TEST(TricycleOdometry, SteersAnArcByTheMeanOfItsEnds) {
  TricycleOdometry odometry(vehicle(), encoders());
  odometry.add(reading_of(0, 0, 0.1));
  odometry.add(reading_of(20, 400, 0.3));
  const double mean = 0.5 * (measured(0.1) + measured(0.3));
  test::expect_near(odometry.odom_T_base(), drive_arc(vehicle(), 400.0, mean), 1e-12);
}

// With a wheel that looks back the mean of the two numbers would be a wheel that looks ahead.
TEST(TricycleOdometry, MeansTheShorterWayRoundTheEncoder) {
  TricycleOdometry odometry(vehicle(), encoders());
  odometry.add(reading_of(0, 0, kPi - 0.05));
  odometry.add(reading_of(20, 400, -kPi + 0.05));
  const double mean =
      measured(kPi - 0.05) + 0.5 * (angle_between(measured(kPi - 0.05), measured(-kPi + 0.05)));
  test::expect_near(odometry.odom_T_base(), drive_arc(vehicle(), 400.0, mean), 1e-12);
  EXPECT_LT(odometry.odom_T_base().x(), -0.09);
}

TEST(TricycleOdometry, KnowsItsVelocityOverTheLastStep) {
  TricycleOdometry odometry(vehicle(), encoders());
  odometry.add(reading_of(0, 0, 0.0));
  odometry.add(reading_of(100, 4000, 0.0));
  odometry.add(reading_of(300, 4800, 0.4));
  const double direction = 0.5 * (measured(0.0) + measured(0.4)) + 0.01;
  const double wheel_speed = 800 * 2.5e-4 / 0.2;
  EXPECT_NEAR(odometry.velocity().forward, wheel_speed * std::cos(direction), 1e-12);
  EXPECT_NEAR(odometry.velocity().turn_rate, wheel_speed * std::sin(direction) / 1.4, 1e-12);
  odometry.add(reading_of(400, 4800, 0.4));
  EXPECT_EQ(odometry.velocity().forward, 0.0);
  EXPECT_EQ(odometry.velocity().turn_rate, 0.0);
}

TEST(TricycleOdometry, LeavesOutWhatIsNotLaterAndLosesNothing) {
  TricycleOdometry disturbed(vehicle(), encoders());
  TricycleOdometry calm(vehicle(), encoders());
  for (const EncoderReading& reading : {reading_of(0, 0, 0.2), reading_of(100, 500, 0.2)}) {
    disturbed.add(reading);
    calm.add(reading);
  }
  const OdometryStep repeated = disturbed.add(reading_of(100, 600, 0.2));
  EXPECT_EQ(repeated.verdict, OdometryVerdict::kNotLater);
  EXPECT_EQ(repeated.ticks, 100);
  EXPECT_EQ(disturbed.add(reading_of(50, 250, 0.2)).verdict, OdometryVerdict::kNotLater);
  test::expect_near(disturbed.odom_T_base(), calm.odom_T_base(), 0.0);
  EXPECT_EQ(disturbed.velocity().forward, calm.velocity().forward);

  disturbed.add(reading_of(200, 1000, 0.2));
  calm.add(reading_of(200, 1000, 0.2));
  test::expect_near(disturbed.odom_T_base(), calm.odom_T_base(), 0.0);
}

TEST(TricycleOdometry, GoesOnFromItsPoseAfterARestart) {
  TricycleOdometry odometry(vehicle(), encoders());
  odometry.add(reading_of(1000, 0, 0.2));
  odometry.add(reading_of(1100, 500, 0.2));
  const Pose2 before = odometry.odom_T_base();
  odometry.restart();
  EXPECT_EQ(odometry.velocity().forward, 0.0);
  EXPECT_EQ(odometry.add(reading_of(0, 9000, 0.2)).verdict, OdometryVerdict::kFirst);
  test::expect_near(odometry.odom_T_base(), before, 0.0);
  odometry.add(reading_of(100, 9500, 0.2));
  test::expect_near(odometry.odom_T_base(), before * drive_arc(vehicle(), 500.0, measured(0.2)),
                    1e-12);
}

TEST(TricycleOdometry, TellsJumpsFromMotion) {
  TricycleOdometryParams params;
  params.max_wheel_speed = 2.0;  // 800 ticks in 0.1 s
  TricycleOdometry odometry(vehicle(), encoders(), {}, params);
  odometry.add(reading_of(0, 0, 0.2));
  EXPECT_EQ(odometry.add(reading_of(100, 799, 0.2)).verdict, OdometryVerdict::kIntegrated);
  const Pose2 before = odometry.odom_T_base();
  const OdometryStep jump = odometry.add(reading_of(200, -1000000, 0.2));
  EXPECT_EQ(jump.verdict, OdometryVerdict::kJump);
  EXPECT_EQ(jump.ticks, -1000799);
  test::expect_near(odometry.odom_T_base(), before, 0.0);
  EXPECT_EQ(odometry.velocity().forward, 0.0);
  EXPECT_EQ(odometry.add(reading_of(300, -999201, 0.2)).verdict, OdometryVerdict::kIntegrated);
  test::expect_near(odometry.odom_T_base(), drive_arc(vehicle(), 2.0 * 799.0, measured(0.2)),
                    1e-12);
  EXPECT_EQ(odometry.add(reading_of(400, -1000002, 0.2)).verdict, OdometryVerdict::kJump);
}

TEST(TricycleOdometry, TakesEveryStepForMotionIfNotTold) {
  TricycleOdometry odometry(vehicle(), encoders());
  odometry.add(reading_of(0, 0, 0.2));
  EXPECT_EQ(odometry.add(reading_of(1, 1000000, 0.2)).verdict, OdometryVerdict::kIntegrated);
}

// Whether a drive is read often or seldom, its pose is nearly that of its true motion.
TEST(TricycleOdometry, FollowsADriveWithChangingSteering) {
  TricycleOdometry odometry(vehicle(), encoders());
  Pose2 truth;
  constexpr int kSteps = 20000;
  constexpr double kTicks = 1.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double steering = 0.8 * std::sin(12.0 * share);
    if (i % 100 == 0) odometry.add(reading_of(i, i, steering));
    if (i < kSteps) truth = truth * drive_arc(vehicle(), kTicks, steering);
  }
  test::expect_near(odometry.odom_T_base(), truth, 0.005);
}

TEST(TricycleOdometry, RefusesParametersByName) {
  const auto error_of = [](const TricycleParams& tricycle, const EncoderParams& encoders,
                           double max_wheel_speed) -> std::string {
    TricycleOdometryParams params;
    params.max_wheel_speed = max_wheel_speed;
    try {
      TricycleOdometry(tricycle, encoders, {}, params);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  TricycleParams tricycle = vehicle();
  tricycle.wheelbase = -1.0;
  EncoderParams encoder = encoders();
  encoder.steer_zero = 9000;
  EXPECT_EQ(error_of(tricycle, encoders(), 0.0).find("wheelbase = -1:"), 0U);
  EXPECT_EQ(error_of(vehicle(), encoder, 0.0).find("steer_zero = 9000:"), 0U);
  EXPECT_EQ(error_of(vehicle(), encoders(), -1.0).find("max_wheel_speed = -1:"), 0U);
  EXPECT_EQ(error_of(vehicle(), encoders(), std::nan("")).find("max_wheel_speed = nan:"), 0U);
  EXPECT_EQ(error_of(vehicle(), encoders(), 2.0), "no error");
}

}  // namespace
}  // namespace falko_slam
