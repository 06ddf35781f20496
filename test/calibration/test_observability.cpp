// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/observability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "calibration/arc_drives.hpp"

namespace falko_slam {
namespace {

constexpr auto kAsymmetric = TricycleModel::kAsymmetric;
constexpr auto kStandard = TricycleModel::kStandard;

std::vector<PathSegment> drives(const std::vector<std::pair<double, double>>& controls) {
  std::vector<PathSegment> segments;
  for (const auto& [ticks, degrees] : controls) {
    segments.push_back(test::exact_segment(test::cb16(), ticks, degrees_to_radians(degrees)));
  }
  return segments;
}

// The values of Table 5.1's plans: (2.41) gives 3.753 for the first, its root is right.
TEST(Observability, HasTheConditionNumbersOfTheTables) {
  const auto wide = check_observability(test::exact_segments(test::cb16()), kStandard);
  EXPECT_EQ(wide.verdict, CalibrationVerdict::kOk);
  EXPECT_NEAR(wide.forward_condition, 1.937, 2e-3);
  EXPECT_TRUE(wide.remarks.empty());

  test::ArcPlan narrow;
  narrow.max_steering = degrees_to_radians(34.0);
  const auto report = check_observability(test::exact_segments(test::cb16(), narrow), kAsymmetric);
  EXPECT_EQ(report.verdict, CalibrationVerdict::kOk);
  EXPECT_NEAR(report.forward_condition, 2.26, 0.02);
  EXPECT_NEAR(report.backward_condition, 2.26, 0.02);
  EXPECT_LT(report.laser_condition, 2.0);
}

TEST(Observability, RefusesNothingAtAll) {
  for (const auto model : {kStandard, kAsymmetric}) {
    EXPECT_EQ(check_observability({}, model).verdict, CalibrationVerdict::kUnobservable);
  }
}

TEST(Observability, RefusesStraightDrives) {
  const auto report =
      check_observability(drives({{9000, 0}, {-9000, 0}, {5000, 0}, {-5000, 0}}), kAsymmetric);
  EXPECT_EQ(report.verdict, CalibrationVerdict::kUnobservable);
  EXPECT_EQ(report.remarks.front().remedy, "drive forward arcs to the left and right");
}

TEST(Observability, RefusesOneSideOnly) {
  const auto report = check_observability(
      drives({{9000, 20}, {9000, 30}, {9000, 45}, {-9000, 20}, {-9000, 30}, {-9000, 45}}),
      kAsymmetric);
  EXPECT_EQ(report.verdict, CalibrationVerdict::kUnobservable);
  EXPECT_EQ(report.remarks.front().reason, "the forward arcs leave out right");
  EXPECT_EQ(report.remarks.front().remedy, "drive forward arcs to the right");
}

TEST(Observability, RefusesASingleArc) {
  for (const auto model : {kStandard, kAsymmetric}) {
    EXPECT_EQ(check_observability(drives({{9000, 30}}), model).verdict,
              CalibrationVerdict::kUnobservable);
  }
}

TEST(Observability, NeedsBothDirectionsForTwoOffsetsOnly) {
  const auto forward = drives({{9000, 20}, {9000, 45}, {9000, -20}, {9000, -45}});
  EXPECT_EQ(check_observability(forward, kStandard).verdict, CalibrationVerdict::kOk);
  const auto report = check_observability(forward, kAsymmetric);
  EXPECT_EQ(report.verdict, CalibrationVerdict::kUnobservable);
  ASSERT_EQ(report.remarks.size(), 1U);
  EXPECT_EQ(report.remarks[0].parameters.front(), CalibrationParameter::kSteerOffsetBackward);
  EXPECT_EQ(report.remarks[0].remedy, "drive backward arcs to the left and right");
}

TEST(Observability, CallsFlatArcsWeakAndAsksForMoreSteering) {
  const auto report = check_observability(
      drives({{40000, 7}, {40000, -7}, {-40000, 7}, {-40000, -7}}), kAsymmetric);
  EXPECT_EQ(report.verdict, CalibrationVerdict::kWeak);
  EXPECT_NEAR(report.forward_condition, 1.0 / std::tan(degrees_to_radians(7.0)), 0.01);
  EXPECT_NE(report.remarks.front().remedy.find("more steering"), std::string::npos);
}

TEST(Observability, RefusesTurnsThatAreWholeOrNone) {
  test::ArcPlan plan;
  VehicleCalibration vehicle = test::cb16();
  vehicle.tricycle.steer_offset_forward = vehicle.tricycle.steer_offset_backward = 0.0;
  plan.turn = kTwoPi;
  const auto whole = check_observability(test::exact_segments(vehicle, plan), kAsymmetric);
  EXPECT_EQ(whole.verdict, CalibrationVerdict::kUnobservable);
  EXPECT_EQ(whole.remarks.front().parameters.front(), CalibrationParameter::kLaserX);
  plan.turn = degrees_to_radians(5.0);
  const auto hardly = check_observability(test::exact_segments(vehicle, plan), kAsymmetric);
  EXPECT_EQ(hardly.verdict, CalibrationVerdict::kWeak);
  EXPECT_NE(hardly.remarks.front().reason.find("hardly turn"), std::string::npos);
}

TEST(Observability, ChecksItsParams) {
  ObservabilityParams params;
  params.weak_condition = 0.5;
  EXPECT_THROW(check_observability({}, kStandard, params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
