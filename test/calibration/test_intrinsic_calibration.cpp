// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/intrinsic_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibration/arc_drives.hpp"
#include "calibration/pattern_search.hpp"

namespace falko_slam {
namespace {

// (2.12) written out: parameters s_w / L and the two offsets.
double angle_cost(const std::vector<PathSegment>& segments, const Eigen::Vector3d& parameters) {
  double sum = 0.0;
  for (const PathSegment& segment : segments) {
    const double offset = segment.ticks > 0.0 ? parameters[1] : parameters[2];
    const double turn = parameters[0] * segment.ticks * std::sin(segment.steering + offset);
    sum += std::pow(turn - segment.turn, 2);
  }
  return sum;
}

std::vector<PathSegment> with_noisy_turns(std::mt19937_64& random,
                                          const VehicleCalibration& vehicle) {
  auto segments = test::exact_segments(vehicle, {3, 0.3, 0.9, test::uniform(random, 1.0, 4.0)});
  for (PathSegment& segment : segments) segment.turn += test::normal(random, 0.2);
  return segments;
}

TEST(StandardCalibration, GivesRandomVehiclesBack) {
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) {
    VehicleCalibration vehicle = test::random_vehicle(random);
    vehicle.tricycle.steer_offset_backward = vehicle.tricycle.steer_offset_forward;
    const double wheelbase = vehicle.tricycle.wheelbase;

    const auto found = calibrate_standard(test::exact_segments(vehicle), wheelbase);

    ASSERT_TRUE(found);
    const TricycleParams& truth = vehicle.tricycle;
    EXPECT_NEAR(found->driving_scale / truth.driving_scale, 1.0, 1e-9);
    EXPECT_NEAR(found->steer_offset_forward, truth.steer_offset_forward, 1e-9 * 0.1);
    EXPECT_EQ(found->steer_offset_forward, found->steer_offset_backward);
    EXPECT_EQ(found->wheelbase, wheelbase);
  }
}

TEST(AsymmetricCalibration, GivesRandomVehiclesBack) {
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) {
    const VehicleCalibration vehicle = test::random_vehicle(random);
    const TricycleParams& truth = vehicle.tricycle;

    const auto found = calibrate_asymmetric(test::exact_segments(vehicle), truth.wheelbase);

    ASSERT_TRUE(found);
    EXPECT_NEAR(found->driving_scale / truth.driving_scale, 1.0, 1e-9);
    EXPECT_NEAR(found->steer_offset_forward, truth.steer_offset_forward, 1e-9 * 0.1);
    EXPECT_NEAR(found->steer_offset_backward, truth.steer_offset_backward, 1e-9 * 0.1);
  }
}

TEST(StandardCalibration, IsTheMinimumThatBruteForceFinds) {
  auto random = test::seeded_random();
  for (int i = 0; i < 20; ++i) {
    VehicleCalibration vehicle = test::random_vehicle(random);
    vehicle.tricycle.steer_offset_backward = vehicle.tricycle.steer_offset_forward;
    const TricycleParams& truth = vehicle.tricycle;
    const auto segments = with_noisy_turns(random, vehicle);
    const double scale = truth.driving_scale / truth.wheelbase;

    const auto found = calibrate_standard(segments, truth.wheelbase);
    const Eigen::VectorXd lowest = test::pattern_search(
        [&](const Eigen::VectorXd& p) {
          return angle_cost(segments, {p[0], p[1], p[1]});
        },
        Eigen::Vector2d(scale, truth.steer_offset_forward), Eigen::Vector2d(0.1 * scale, 0.1));

    ASSERT_TRUE(found);
    EXPECT_NEAR(found->driving_scale / truth.wheelbase / lowest[0], 1.0, 1e-6);
    EXPECT_NEAR(found->steer_offset_forward, lowest[1], 1e-6);
  }
}

TEST(AsymmetricCalibration, IsTheMinimumThatBruteForceFinds) {
  auto random = test::seeded_random();
  for (int i = 0; i < 20; ++i) {
    const VehicleCalibration vehicle = test::random_vehicle(random);
    const TricycleParams& truth = vehicle.tricycle;
    const auto segments = with_noisy_turns(random, vehicle);
    const double scale = truth.driving_scale / truth.wheelbase;

    const auto found = calibrate_asymmetric(segments, truth.wheelbase);
    const Eigen::VectorXd lowest = test::pattern_search(
        [&](const Eigen::VectorXd& p) { return angle_cost(segments, Eigen::Vector3d(p)); },
        Eigen::Vector3d(scale, truth.steer_offset_forward, truth.steer_offset_backward),
        Eigen::Vector3d(0.1 * scale, 0.1, 0.1));

    ASSERT_TRUE(found);
    EXPECT_NEAR(found->driving_scale / truth.wheelbase / lowest[0], 1.0, 1e-6);
    EXPECT_NEAR(found->steer_offset_forward, lowest[1], 1e-6);
    EXPECT_NEAR(found->steer_offset_backward, lowest[2], 1e-6);
  }
}

TEST(StandardCalibration, HasNoAnswerForOneSteeringAngle) {
  const VehicleCalibration vehicle = test::cb16();
  const std::vector<PathSegment> segments = {test::exact_segment(vehicle, 9000.0, 0.5),
                                             test::exact_segment(vehicle, 17000.0, 0.5),
                                             test::exact_segment(vehicle, -17000.0, 0.5)};

  EXPECT_FALSE(calibrate_standard({}, 1.358));
  EXPECT_FALSE(calibrate_standard({segments[0]}, 1.358));
  EXPECT_FALSE(calibrate_asymmetric(segments, 1.358));
}

}  // namespace
}  // namespace falko_slam
