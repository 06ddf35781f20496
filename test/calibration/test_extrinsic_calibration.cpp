// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/extrinsic_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibration/arc_drives.hpp"
#include "calibration/pattern_search.hpp"

namespace falko_slam {
namespace {

// (2.29) and (2.31) written out.
double position_cost(const std::vector<PathSegment>& segments, const TricycleParams& tricycle,
                     const Pose2& laser) {
  double sum = 0.0;
  for (const PathSegment& segment : segments) {
    const Pose2 base_motion(base_displacement(segment, tricycle), segment.turn);
    const Eigen::Vector2d by_laser = laser * segment.start_T_end.pose.translation();
    sum += (by_laser - base_motion * laser.translation()).squaredNorm();
  }
  return sum;
}

std::vector<PathSegment> with_noisy_positions(std::mt19937_64& random,
                                              const VehicleCalibration& vehicle) {
  auto segments = test::exact_segments(vehicle, {2, 0.3, 0.9, test::uniform(random, 0.5, 4.0)});
  for (PathSegment& segment : segments) {
    Pose2& pose = segment.start_T_end.pose;
    pose = Pose2(pose.x() + test::normal(random, 0.2), pose.y() + test::normal(random, 0.2),
                 pose.theta());
  }
  return segments;
}

TEST(LaserCalibration, GivesRandomLasersBack) {
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) {
    const VehicleCalibration vehicle = test::random_vehicle(random);

    const auto found = calibrate_laser_pose(test::exact_segments(vehicle), vehicle.tricycle);

    ASSERT_TRUE(found);
    const Pose2& truth = vehicle.base_T_laser;
    EXPECT_LT((found->translation() - truth.translation()).norm(),
              1e-9 * truth.translation().norm());
    EXPECT_NEAR(angle_between(truth.theta(), found->theta()), 0.0, 1e-9);
  }
}

// From both ends of the circle: of the two stationary points it is the lowest one.
TEST(LaserCalibration, IsTheMinimumThatBruteForceFinds) {
  auto random = test::seeded_random();
  for (int i = 0; i < 20; ++i) {
    const VehicleCalibration vehicle = test::random_vehicle(random);
    const auto segments = with_noisy_positions(random, vehicle);
    const auto cost = [&](const Eigen::VectorXd& l) {
      return position_cost(segments, vehicle.tricycle, {l[0], l[1], l[2]});
    };

    const auto found = calibrate_laser_pose(segments, vehicle.tricycle);

    ASSERT_TRUE(found);
    const Eigen::Vector3d closed(found->x(), found->y(), found->theta());
    for (const double start : {0.0, 2.0, 4.0}) {
      const Eigen::VectorXd lowest =
          test::pattern_search(cost, Eigen::Vector3d(0.0, 0.0, start), Eigen::Vector3d::Ones());
      EXPECT_LE(cost(closed), cost(lowest) * (1.0 + 1e-9));
      EXPECT_LT((lowest.head<2>() - closed.head<2>()).norm(), 1e-5);
      EXPECT_NEAR(angle_between(lowest[2], closed[2]), 0.0, 1e-5);
    }
  }
}

TEST(LaserCalibration, FindsALaserBehindTheAxleThatLooksBack) {
  VehicleCalibration vehicle = test::cb16();
  vehicle.base_T_laser = {-0.7, 0.2, -3.0};

  const auto found = calibrate_laser_pose(test::exact_segments(vehicle), vehicle.tricycle);

  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x(), -0.7, 1e-9);
  EXPECT_NEAR(found->y(), 0.2, 1e-9);
  EXPECT_NEAR(found->theta(), -3.0, 1e-9);
}

TEST(LaserCalibration, UsesStraightSegments) {
  const VehicleCalibration vehicle = test::cb16();
  const double straight = -vehicle.tricycle.steer_offset_forward;
  const std::vector<PathSegment> segments = {test::exact_segment(vehicle, 20000.0, straight),
                                             test::exact_segment(vehicle, 9000.0, 0.5)};

  const auto found = calibrate_laser_pose(segments, vehicle.tricycle);

  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x(), vehicle.base_T_laser.x(), 1e-9);
  EXPECT_NEAR(found->y(), vehicle.base_T_laser.y(), 1e-9);
}

// Proposition 2.4.3 would have it otherwise: it takes two centres of rotation.
TEST(LaserCalibration, HasNoAnswerForOneCentreOfRotation) {
  VehicleCalibration vehicle = test::cb16();
  vehicle.tricycle.steer_offset_backward = vehicle.tricycle.steer_offset_forward;
  const std::vector<PathSegment> arcs = {test::exact_segment(vehicle, 9000.0, 0.5),
                                         test::exact_segment(vehicle, 17000.0, 0.5),
                                         test::exact_segment(vehicle, -17000.0, 0.5)};
  const std::vector<PathSegment> straight = {
      test::exact_segment(vehicle, 9000.0, -vehicle.tricycle.steer_offset_forward)};

  EXPECT_FALSE(calibrate_laser_pose(arcs, vehicle.tricycle));
  EXPECT_FALSE(calibrate_laser_pose(straight, vehicle.tricycle));
  EXPECT_FALSE(calibrate_laser_pose({}, vehicle.tricycle));
}

}  // namespace
}  // namespace falko_slam
