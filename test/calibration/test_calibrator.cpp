// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibrator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "calibration/arc_drives.hpp"
#include "falko_slam/calibration/calibration_report.hpp"
#include "falko_slam/calibration/monte_carlo.hpp"

namespace falko_slam {
namespace {

void expect_same(const VehicleCalibration& found, const VehicleCalibration& truth, double share) {
  const CalibrationVector a = vector_of(found), b = vector_of(truth);
  const double length = truth.base_T_laser.translation().norm();
  EXPECT_NEAR(a[0], b[0], share * 0.1);
  EXPECT_NEAR(a[1], b[1], share * 0.1);
  EXPECT_NEAR(a[2] / b[2], 1.0, share);
  EXPECT_NEAR(a[3], b[3], share * length);
  EXPECT_NEAR(a[4], b[4], share * length);
  EXPECT_NEAR(angle_between(b[5], a[5]), 0.0, share);
  EXPECT_NEAR(a[6] / b[6], 1.0, share);
  EXPECT_NEAR(a[7] / b[7], 1.0, share);
}

CalibratorParams params_for(const VehicleCalibration& vehicle) {
  CalibratorParams params;
  params.wheelbase = vehicle.tricycle.wheelbase;
  return params;
}

// Simulated, with the noise of real calibrations.
std::vector<PathSegment> noisy_segments(std::uint64_t seed = test::kSeed,
                                        const VehicleCalibration& vehicle = test::cb16()) {
  std::mt19937_64 random(seed);
  MonteCarloParams params;
  params.truth = vehicle;
  return simulate_calibration_drive(thesis_conditions()[5], params, random);
}

TEST(Calibrator, GivesRandomVehiclesBack) {
  auto random = test::seeded_random();
  for (int i = 0; i < 50; ++i) {
    VehicleCalibration vehicle = test::random_vehicle(random);
    CalibratorParams params = params_for(vehicle);
    params.noise.unknown_factor = 1.0;  // less to compute
    for (const auto model : {TricycleModel::kAsymmetric, TricycleModel::kStandard}) {
      params.model = model;
      if (model == TricycleModel::kStandard) {
        vehicle.tricycle.steer_offset_backward = vehicle.tricycle.steer_offset_forward;
      }

      const CalibrationResult result = calibrate(test::exact_segments(vehicle), params);

      ASSERT_TRUE(result.estimate) << result.remarks.front().reason;
      EXPECT_TRUE(result.estimate->converged);
      expect_same(result.estimate->calibration, vehicle, 1e-9);
      expect_same(*result.closed_form, vehicle, 1e-9);
    }
  }
}

TEST(Calibrator, IsOkWithTheNoiseOfRealCalibrations) {
  const CalibrationResult result = calibrate(noisy_segments());

  EXPECT_EQ(result.verdict, CalibrationVerdict::kOk);
  EXPECT_TRUE(result.remarks.empty());
  EXPECT_TRUE(result.tied.empty());
  ASSERT_TRUE(result.estimate);
  EXPECT_EQ(result.estimate->segments.size(), 16U);
  EXPECT_EQ(result.estimate->degrees_of_freedom, 42);
  for (std::size_t i = 0; i < 6; ++i) {
    const double found = vector_of(result.estimate->calibration)[static_cast<Eigen::Index>(i)];
    EXPECT_LT(result.estimate->intervals[i].low, found);
    EXPECT_GT(result.estimate->intervals[i].high, found);
  }
  EXPECT_EQ(result.estimate->covariance(6, 6), 0.0);
}

TEST(Calibrator, ConvergesFromAWrongStart) {
  const auto segments = noisy_segments();
  CalibratorParams params;
  const CalibrationResult expected = calibrate(segments, params);
  for (const double sign : {1.0, -1.0}) {
    VehicleCalibration start = test::cb16();
    start.tricycle.driving_scale *= 1.0 + 0.05 * sign;
    start.tricycle.steer_offset_forward += sign * degrees_to_radians(2.0);
    start.tricycle.steer_offset_backward -= sign * degrees_to_radians(2.0);
    const Pose2& laser = start.base_T_laser;
    start.base_T_laser = {laser.x() + sign * 0.1, laser.y() - sign * 0.1,
                          laser.theta() + sign * degrees_to_radians(5.0)};
    params.start = start;

    const CalibrationResult result = calibrate(segments, params);

    ASSERT_TRUE(result.estimate);
    EXPECT_EQ(result.verdict, CalibrationVerdict::kOk);
    const CalibrationVector apart =
        vector_of(result.estimate->calibration) - vector_of(expected.estimate->calibration);
    for (Eigen::Index i = 0; i < 6; ++i) {
      EXPECT_LT(std::abs(apart[i]), 0.01 * std::sqrt(expected.estimate->covariance(i, i))) << i;
    }
  }
}

TEST(Calibrator, LeavesOutliersOutAndNamesThem) {
  auto segments = noisy_segments();
  const CalibrationResult sound = calibrate(segments);
  segments[3].ticks *= 1.08;
  PathSegment& slipped = segments[9];
  slipped.turn += 0.1;
  const Pose2 pose = slipped.start_T_end.pose;
  slipped.start_T_end.pose = Pose2(pose.x(), pose.y() + 0.2, pose.theta() + 0.1);

  const CalibrationResult result = calibrate(segments);

  ASSERT_TRUE(result.estimate);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    EXPECT_EQ(result.estimate->segments[i].used, i != 3 && i != 9) << i;
  }
  ASSERT_EQ(result.remarks.size(), 2U);
  EXPECT_EQ(result.remarks[0].reason.substr(0, 36), "segment 4 (forward left) was left ou");
  EXPECT_EQ(result.verdict, CalibrationVerdict::kOk);
  const CalibrationVector apart =
      vector_of(result.estimate->calibration) - vector_of(sound.estimate->calibration);
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_LT(std::abs(apart[i]), std::sqrt(sound.estimate->covariance(i, i))) << i;
  }
}

TEST(Calibrator, TakesAPhaseThatSlippedForNoOutlierAndWidens) {
  auto segments = noisy_segments();
  const CalibrationResult sound = calibrate(segments);
  for (std::size_t i = 0; i < 4; ++i) segments[i].ticks *= 1.01;

  const CalibrationResult result = calibrate(segments);

  ASSERT_TRUE(result.estimate);
  for (const SegmentReport& segment : result.estimate->segments) EXPECT_TRUE(segment.used);
  EXPECT_GT(result.estimate->covariance(2, 2), 4.0 * sound.estimate->covariance(2, 2));
  EXPECT_LT(result.estimate->phase_errors[0].slip, result.estimate->phase_errors[1].slip - 0.005);
  const double truth = test::cb16().tricycle.driving_scale;
  EXPECT_LT(result.estimate->intervals[2].low, truth);
  EXPECT_GT(result.estimate->intervals[2].high, truth);
}

TEST(Calibrator, FindsWheelbaseAndSteerGainWhereAskedTo) {
  VehicleCalibration vehicle = test::cb16();
  vehicle.steer_gain = 1.04;
  CalibratorParams params;
  params.wheelbase = 1.3;
  params.free_wheelbase = true;
  params.free_steer_gain = true;

  const CalibrationResult result = calibrate(test::exact_segments(vehicle), params);

  ASSERT_TRUE(result.estimate);
  expect_same(result.estimate->calibration, vehicle, 1e-6);
  EXPECT_GT(result.estimate->covariance(6, 6), 0.0);
  EXPECT_GT(result.estimate->covariance(7, 7), 0.0);
}

TEST(Calibrator, SaysWhatFewFlatArcsTieAndWhichArcWouldHelp) {
  const VehicleCalibration vehicle = test::cb16();
  CalibratorParams params;
  params.free_wheelbase = true;
  params.free_steer_gain = true;
  test::ArcPlan plan{2, degrees_to_radians(14.0), degrees_to_radians(16.0),
                     degrees_to_radians(30.0)};

  const CalibrationResult result = calibrate(test::exact_segments(vehicle, plan), params);

  ASSERT_TRUE(result.estimate);
  EXPECT_EQ(result.verdict, CalibrationVerdict::kWeak);
  EXPECT_GE(result.tied.size(), 3U);
  EXPECT_NE(result.remarks.back().remedy.find("half a turn steered by about 50 degrees"),
            std::string::npos)
      << result.remarks.back().remedy;
}

TEST(Calibrator, SaysWhenThereIsMoreNoiseThanWasSaid) {
  auto segments = noisy_segments();
  for (PathSegment& segment : segments) segment.start_T_end.covariance *= 0.1;
  CalibratorParams params;
  params.outliers.probability = 0.0;

  const CalibrationResult result = calibrate(segments, params);

  ASSERT_TRUE(result.estimate);
  EXPECT_EQ(result.verdict, CalibrationVerdict::kWeak);
  EXPECT_GT(result.estimate->excess, 2.0);
  EXPECT_NE(result.remarks.front().reason.find("more noise than was said"), std::string::npos);
}

// Wrong data: a verdict, never a number.

void expect_refused(const std::vector<PathSegment>& segments, CalibrationVerdict verdict) {
  for (const auto model : {TricycleModel::kAsymmetric, TricycleModel::kStandard}) {
    CalibratorParams params;
    params.model = model;
    const CalibrationResult result = calibrate(segments, params);
    EXPECT_EQ(result.verdict, verdict);
    EXPECT_FALSE(result.estimate);
    EXPECT_FALSE(result.closed_form);
    ASSERT_FALSE(result.remarks.empty());
    EXPECT_FALSE(result.remarks.front().reason.empty());
    EXPECT_FALSE(result.remarks.front().remedy.empty());
  }
}

std::vector<PathSegment> only(const std::vector<DrivePhase>& phases) {
  std::vector<PathSegment> some;
  for (const PathSegment& segment : noisy_segments()) {
    for (const DrivePhase phase : phases) {
      if (phase_of(segment) == phase) some.push_back(segment);
    }
  }
  return some;
}

TEST(Calibrator, GivesNoNumberForDrivesThatTellTooLittle) {
  expect_refused({}, CalibrationVerdict::kUnobservable);
  expect_refused({noisy_segments().front()}, CalibrationVerdict::kUnobservable);
  expect_refused(only({DrivePhase::kForwardLeft}), CalibrationVerdict::kUnobservable);
  expect_refused(only({DrivePhase::kForwardLeft, DrivePhase::kBackwardLeft}),
                 CalibrationVerdict::kUnobservable);
  expect_refused(only({DrivePhase::kForwardRight, DrivePhase::kBackwardRight}),
                 CalibrationVerdict::kUnobservable);
  auto random = test::seeded_random();
  std::vector<PathSegment> straight;
  for (int i = 0; i < 16; ++i) {
    straight.push_back(
        test::exact_segment(test::cb16(), i % 2 ? 20000.0 : -20000.0, test::normal(random, 2e-4)));
  }
  expect_refused(straight, CalibrationVerdict::kUnobservable);
}

TEST(Calibrator, GivesNoNumberForReversedSigns) {
  auto ticks = noisy_segments(), steering = ticks, egomotion = ticks, both = ticks;
  for (PathSegment& segment : ticks) segment.ticks = -segment.ticks;
  expect_refused(ticks, CalibrationVerdict::kContradictory);
  for (PathSegment& segment : steering) segment.steering = -segment.steering;
  expect_refused(steering, CalibrationVerdict::kContradictory);
  const auto turn_round = [](PathSegment& segment) {
    segment.start_T_end = inverse(segment.start_T_end);
    segment.turn = -segment.turn;
  };
  for (PathSegment& segment : egomotion) turn_round(segment);
  expect_refused(egomotion, CalibrationVerdict::kContradictory);
  // Two wrongs make a vehicle: one whose laser looks back.
  for (PathSegment& segment : both) {
    turn_round(segment);
    segment.steering = -segment.steering;
  }
  const CalibrationResult result = calibrate(both);
  ASSERT_TRUE(result.estimate);
  EXPECT_GT(std::abs(result.estimate->calibration.base_T_laser.theta()), 3.0);
}

TEST(Calibrator, RefusesWhatIsNoSegmentOrNoParameter) {
  auto segments = noisy_segments();
  segments[2].ticks = 0.0;
  EXPECT_THROW(calibrate(segments), std::invalid_argument);
  segments[2].ticks = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(calibrate(segments), std::invalid_argument);
  CalibratorParams params;
  params.wheelbase = 0.0;
  EXPECT_THROW(calibrate(noisy_segments(), params), std::invalid_argument);
  params = {};
  params.noise.slip = -1.0;
  EXPECT_THROW(calibrate(noisy_segments(), params), std::invalid_argument);
  params = {};
  params.outliers.max_share = 0.9;
  EXPECT_THROW(calibrate(noisy_segments(), params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
