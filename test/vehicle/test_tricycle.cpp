// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/vehicle/tricycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "falko_slam/geometry/angles.hpp"
#include "support/poses.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

using test::uniform;

const double kSmallAngles[] = {0.0, 1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3};

struct Drive {
  TricycleParams params;
  double ticks;
  double steering;
};

Drive random_drive(std::mt19937_64& random) {
  return {{uniform(random, 0.5, 3.0), uniform(random, 1e-4, 1e-3), uniform(random, -0.2, 0.2),
           uniform(random, -0.2, 0.2)},
          uniform(random, -2e4, 2e4),
          uniform(random, -1.5, 1.5)};
}

// The velocities (2.2), (2.3) summed up in steps of the midpoint rule, the steering changing
// evenly.
Pose2 integrate(const Drive& drive, double steering_after, int steps) {
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  const double way = drive.params.driving_scale * drive.ticks / steps;
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps;
    const double measured = drive.steering + share * (steering_after - drive.steering);
    const double direction = true_steering(drive.params, measured, drive.ticks);
    const double turn = way * std::sin(direction) / drive.params.wheelbase;
    const double heading = q.z() + 0.5 * turn;
    q += Eigen::Vector3d(way * std::cos(direction) * std::cos(heading),
                         way * std::cos(direction) * std::sin(heading), turn);
  }
  return {q.x(), q.y(), q.z()};
}

using ArcOf = std::function<Pose2(double)>;

Eigen::Vector3d central_difference(const ArcOf& arc, double at, double step) {
  return difference(arc(at + step), arc(at - step)) / (2.0 * step);
}

void expect_jacobians_of(const Drive& drive) {
  const auto [params, ticks, steering] = drive;
  const ArcJacobians jacobians = arc_jacobians(params, ticks, steering);
  const auto with = [&](double TricycleParams::*field) {
    return [&drive, field](double value) {
      TricycleParams changed = drive.params;
      changed.*field = value;
      return drive_arc(changed, drive.ticks, drive.steering);
    };
  };
  const auto offset =
      ticks > 0.0 ? &TricycleParams::steer_offset_forward : &TricycleParams::steer_offset_backward;
  Eigen::Matrix<double, 3, 5> expected;
  expected << central_difference(
      [&](double value) { return drive_arc(drive.params, value, drive.steering); }, ticks, 1e-2),
      central_difference([&](double value) { return drive_arc(drive.params, drive.ticks, value); },
                         steering, 1e-5),
      central_difference(with(&TricycleParams::wheelbase), params.wheelbase, 1e-5),
      central_difference(with(&TricycleParams::driving_scale), params.driving_scale, 1e-8),
      central_difference(with(offset), params.*offset, 1e-5);
  Eigen::Matrix<double, 3, 5> computed;
  computed << jacobians.darc_dcontrol, jacobians.darc_dparams;
  for (Eigen::Index column = 0; column < 5; ++column) {
    const double scale = expected.col(column).norm() + 1e-6;
    EXPECT_LT((computed - expected).col(column).norm(), 1e-6 * scale)
        << "column " << column << ", " << ticks << " ticks at " << steering << " rad\n"
        << computed << "\ninstead of\n"
        << expected;
  }
}

TEST(Tricycle, DrivesTheArcsOfTheThesis) {
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) {
    const auto [params, ticks, steering] = random_drive(random);
    const double offset = ticks > 0.0 ? params.steer_offset_forward : params.steer_offset_backward;
    // (2.8), (2.9)
    const double turn =
        ticks * params.driving_scale / params.wheelbase *
        (std::sin(steering) * std::cos(offset) + std::cos(steering) * std::sin(offset));
    const double radius = params.wheelbase / std::tan(steering + offset);
    const Pose2 expected(radius * std::sin(turn), radius * (1.0 - std::cos(turn)), turn);
    test::expect_near(drive_arc(params, ticks, steering), expected, 1e-9);
  }
}

TEST(Tricycle, IsWhereItsVelocitiesLeadTo) {
  auto random = test::seeded_random();
  for (int i = 0; i < 20; ++i) {
    const Drive drive = random_drive(random);
    test::expect_near(drive_arc(drive.params, drive.ticks, drive.steering),
                      integrate(drive, drive.steering, 20000), 1e-6);
  }
}

TEST(Tricycle, ArcsBecomeStraightLinesSmoothly) {
  TricycleParams params;
  for (const double size : kSmallAngles) {
    for (const double steering : {size, -size}) {
      const double way = 4000.0 * params.driving_scale;
      const double turn = way * std::sin(steering) / params.wheelbase;
      const Pose2 expected(way * (1.0 - turn * turn / 6.0 - steering * steering / 2.0),
                           0.5 * way * turn, turn);
      const Pose2 arc = drive_arc(params, 4000.0, steering);
      test::expect_near(arc, expected, 1e-9);
      if (size < 1e-8) test::expect_near(arc, expected, 1e-16);
    }
  }
}

TEST(Tricycle, ArcsAreMadeOfShorterOnes) {
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) {
    const auto [params, ticks, steering] = random_drive(random);
    const double share = uniform(random, 0.0, 1.0);
    const Pose2 parts = drive_arc(params, share * ticks, steering) *
                        drive_arc(params, (1.0 - share) * ticks, steering);
    test::expect_near(parts, drive_arc(params, ticks, steering), 1e-11);
  }
}

TEST(Tricycle, DrivesBackTheWayItCameIfTheOffsetsAreEqual) {
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) {
    auto [params, ticks, steering] = random_drive(random);
    params.steer_offset_backward = params.steer_offset_forward;
    const Pose2 there = drive_arc(params, ticks, steering);
    test::expect_near(there * drive_arc(params, -ticks, steering), {}, 1e-11);
  }
}

TEST(Tricycle, EachDirectionHasItsOffset) {
  TricycleParams params;
  params.steer_offset_forward = 0.03;
  params.steer_offset_backward = -0.05;
  TricycleParams forward = params;
  forward.steer_offset_backward = params.steer_offset_forward;
  TricycleParams backward = params;
  backward.steer_offset_forward = params.steer_offset_backward;
  for (const double steering : {-0.7, -0.03, 0.0, 0.05, 0.7}) {
    test::expect_near(drive_arc(params, 3000.0, steering), drive_arc(forward, 3000.0, steering),
                      0.0);
    test::expect_near(drive_arc(params, -3000.0, steering), drive_arc(backward, -3000.0, steering),
                      0.0);
  }
  EXPECT_EQ(drive_arc(params, 3000.0, -0.03).theta(), 0.0);
  EXPECT_EQ(drive_arc(params, -3000.0, 0.05).theta(), 0.0);
}

TEST(Tricycle, AWheelAcrossTurnsOnTheSpot) {
  const TricycleParams params;
  const Pose2 turned = drive_arc(params, 2000.0, kPi / 2.0);
  test::expect_near(turned, {0.0, 0.0, 2000.0 * params.driving_scale / params.wheelbase}, 1e-15);
}

TEST(Tricycle, JacobiansAreThoseOfTheArc) {
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) expect_jacobians_of(random_drive(random));
}

TEST(Tricycle, JacobiansAreSmoothThroughStraightLines) {
  for (const double size : kSmallAngles) {
    for (const double steering : {size, -size}) {
      expect_jacobians_of({{}, 4000.0, steering});
      expect_jacobians_of({{}, -4000.0, steering});
    }
  }
}

// Where the series of the factors gives way to their formula.
TEST(Tricycle, JacobiansHaveNoStepBetweenSeriesAndFormula) {
  const TricycleParams params;
  const double ticks = 4000.0;
  const double seam = std::asin(0.02 * params.wheelbase / (ticks * params.driving_scale));
  const ArcJacobians below = arc_jacobians(params, ticks, seam - 1e-13);
  const ArcJacobians above = arc_jacobians(params, ticks, seam + 1e-13);
  EXPECT_LT((above.darc_dcontrol - below.darc_dcontrol).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LT((above.darc_dparams.col(0) - below.darc_dparams.col(0)).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Tricycle, JacobiansOfAStandStill) {
  TricycleParams params;
  params.steer_offset_backward = 0.1;
  const ArcJacobians jacobians = arc_jacobians(params, 0.0, 0.4);
  const Eigen::Vector3d start(std::cos(0.5), 0.0, std::sin(0.5) / params.wheelbase);
  EXPECT_TRUE(jacobians.darc_dcontrol.col(0).isApprox(params.driving_scale * start, 1e-14));
  EXPECT_TRUE(jacobians.darc_dcontrol.col(1).isZero());
  EXPECT_TRUE(jacobians.darc_dparams.isZero());
}

// (5.8) from any pose, letter by letter.
TEST(TricycleRungeKutta, IsTheFormulaOfTheThesis) {
  auto random = test::seeded_random();
  for (int i = 0; i < 100; ++i) {
    Drive drive = random_drive(random);
    drive.params.steer_offset_forward = drive.params.steer_offset_backward = 0.0;
    const double after = drive.steering + uniform(random, -0.5, 0.5);
    const Pose2 q(uniform(random, -9.0, 9.0), uniform(random, -9.0, 9.0),
                  uniform(random, -kPi, kPi));
    const double L = drive.params.wheelbase;
    const double S_L = drive.ticks * drive.params.driving_scale / L;
    const double alpha_2 = (after + drive.steering) / 2.0;
    const double heading = q.theta() + S_L / 2.0 * std::sin((after + 3.0 * drive.steering) / 4.0);
    const Pose2 expected(q.x() + L * S_L * std::cos(heading) * std::cos(alpha_2),
                         q.y() + L * S_L * std::sin(heading) * std::cos(alpha_2),
                         q.theta() + S_L * std::sin(alpha_2));
    test::expect_near(q * drive_rk2(drive.params, drive.ticks, {drive.steering, after}), expected,
                      1e-12);
  }
}

// A step of half the length, in half the steering's change, errs an eighth.
TEST(TricycleRungeKutta, ErrsInThirdOrder) {
  auto random = test::seeded_random();
  for (int i = 0; i < 20; ++i) {
    Drive drive = random_drive(random);
    drive.ticks = 0.5 * drive.params.wheelbase / drive.params.driving_scale;
    const double rate = uniform(random, 0.2, 0.6) * (i % 2 == 0 ? 1.0 : -1.0);
    const auto error = [&](double length) {
      Drive step = drive;
      step.ticks *= length;
      const double after = step.steering + length * rate;
      const Pose2 truth = integrate(step, after, 4000);
      return difference(drive_rk2(step.params, step.ticks, {step.steering, after}), truth).norm();
    };
    EXPECT_NEAR(error(0.1) / error(0.05), 8.0, 1.2) << i;
    EXPECT_NEAR(error(0.05) / error(0.025), 8.0, 0.8) << i;
  }
}

TEST(TricycleRungeKutta, TakesTheOffsetOfTheDirection) {
  TricycleParams params;
  params.steer_offset_forward = 0.03;
  params.steer_offset_backward = -0.05;
  for (const double ticks : {2000.0, -2000.0}) {
    const double offset = ticks > 0.0 ? 0.03 : -0.05;
    test::expect_near(drive_rk2(params, ticks, {0.1, 0.2}),
                      drive_rk2({}, ticks, {0.1 + offset, 0.2 + offset}), 1e-15);
  }
}

TEST(TricycleParameters, AreRefusedWithTheirNames) {
  const auto error_of = [](double TricycleParams::*field, double value) -> std::string {
    TricycleParams params;
    params.*field = value;
    try {
      validate(params);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_of(&TricycleParams::wheelbase, 0.0).find("wheelbase = 0:"), 0U);
  EXPECT_EQ(error_of(&TricycleParams::driving_scale, -1e-4).find("driving_scale = -0.0001:"), 0U);
  EXPECT_EQ(error_of(&TricycleParams::steer_offset_forward, std::nan("")).find("steer_offset_f"),
            0U);
  EXPECT_EQ(error_of(&TricycleParams::steer_offset_backward, 4.0).find("steer_offset_b"), 0U);
  EXPECT_EQ(error_of(&TricycleParams::wheelbase, 1.4), "no error");
}

}  // namespace
}  // namespace falko_slam
