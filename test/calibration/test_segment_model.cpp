// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "calibration/arc_drives.hpp"

namespace falko_slam {
namespace {

Eigen::Vector3d slope(const std::function<Eigen::Vector3d(double)>& motion, double step) {
  return (motion(step) - motion(-step)) / (2.0 * step);
}

TEST(SegmentModel, IsTheMotionOfTheLaser) {
  const VehicleCalibration vehicle = test::cb16();
  for (const PathSegment& segment : test::exact_segments(vehicle, {3, 0.2, 1.0, 4.2})) {
    const MeasuredStretch stretch = stretch_of(segment);
    EXPECT_LT((predict(vehicle, stretch.arcs).motion - stretch.motion).norm(), 1e-12);
  }
}

TEST(SegmentModel, GoesFromArcToArc) {
  const VehicleCalibration vehicle = test::cb16();
  const PathSegment first = test::exact_segment(vehicle, 9000.0, 0.4);
  const PathSegment second = test::exact_segment(vehicle, -5000.0, -0.7);
  const Pose2 both = first.start_T_end.pose * second.start_T_end.pose;

  const Eigen::Vector3d motion =
      predict(vehicle, {{9000.0, 0.4}, {0.0, 0.1}, {-5000.0, -0.7}}).motion;

  EXPECT_NEAR(motion.x(), both.x(), 1e-12);
  EXPECT_NEAR(motion.y(), both.y(), 1e-12);
  EXPECT_NEAR(motion.z(), first.turn + second.turn, 1e-12);
}

TEST(SegmentModel, HasTheSlopesThatDifferencesShow) {
  auto random = test::seeded_random();
  for (int i = 0; i < 50; ++i) {
    VehicleCalibration vehicle = test::random_vehicle(random);
    vehicle.steer_gain = test::uniform(random, 0.8, 1.2);
    const double way = 1.0 / vehicle.tricycle.driving_scale;
    const std::vector<ArcControl> arcs = {{way, test::uniform(random, -1.0, 1.0)},
                                          {-0.7 * way, test::uniform(random, -1.0, 1.0)},
                                          {0.4 * way, 0.0}};
    const CalibrationVector at = vector_of(vehicle);
    const StretchPrediction prediction = predict(vehicle, arcs);
    for (Eigen::Index p = 0; p < at.size(); ++p) {
      const double step = p == 2 ? 1e-6 * at[p] : 1e-6;
      const Eigen::Vector3d expected = slope(
          [&](double by) {
            CalibrationVector moved = at;
            moved[p] += by;
            return predict(calibration_of(moved), arcs).motion;
          },
          step);
      const Eigen::Vector3d found = prediction.dparameters.col(p);
      EXPECT_LT((found - expected).norm(), 1e-7 * (1.0 + expected.norm())) << p;
    }
    const Eigen::Vector3d dslip = slope(
        [&](double by) {
          return predict(vehicle, arcs, {by, 0.0}).motion;
        },
        1e-6);
    const Eigen::Vector3d dsteer = slope(
        [&](double by) {
          return predict(vehicle, arcs, {0.0, by}).motion;
        },
        1e-6);
    EXPECT_LT((prediction.dslip - dslip).norm(), 1e-7);
    EXPECT_LT((prediction.dsteer - dsteer).norm(), 1e-7);
  }
}

}  // namespace
}  // namespace falko_slam
