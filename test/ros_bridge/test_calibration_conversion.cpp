// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_conversion.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

SessionArc some_arc() {
  SessionArc arc;
  PathSegment& segment = arc.recorded.segment;
  segment.ticks = -1234.0;
  segment.steering = 0.4;
  segment.start_T_end.pose = Pose2(1.0, -2.0, 0.5);
  segment.start_T_end.covariance << 4.0, 1.0, 0.5, 1.0, 5.0, 0.25, 0.5, 0.25, 6.0;
  segment.turn = 0.5 - 2.0 * M_PI;
  arc.recorded.motion.pairs.resize(7);
  arc.residual = Eigen::Vector3d(0.1, 0.2, 0.3);
  return arc;
}

TEST(CalibrationArcMessage, TellsTheArcAndComesBack) {
  const SessionArc arc = some_arc();
  const CalibrationArc message = to_message(arc);
  EXPECT_EQ(message.phase, "backward left");
  EXPECT_EQ(message.reflectors, 7U);
  EXPECT_TRUE(message.used);
  EXPECT_EQ(message.residual.y, 0.2);
  EXPECT_EQ(message.residual.theta, 0.3);

  const PathSegment back = from_message(message);
  const PathSegment& segment = arc.recorded.segment;
  EXPECT_EQ(back.ticks, segment.ticks);
  EXPECT_EQ(back.steering, segment.steering);
  EXPECT_EQ(back.turn, segment.turn);
  EXPECT_EQ(back.start_T_end.pose.x(), 1.0);
  EXPECT_EQ(back.start_T_end.pose.theta(), 0.5);
  EXPECT_EQ(back.start_T_end.covariance, segment.start_T_end.covariance);
}

TEST(CalibrationArcMessage, WithAComplaintHoldsNothingElse) {
  SessionArc arc = some_arc();
  arc.residual.reset();
  arc.recorded.complaint = "too few reflectors";
  const CalibrationArc message = to_message(arc);
  EXPECT_EQ(message.complaint, "too few reflectors");
  EXPECT_FALSE(message.used);
  EXPECT_EQ(message.ticks, 0.0);
}

CalibrationResult some_result() {
  CalibrationResult result;
  result.verdict = CalibrationVerdict::kWeak;
  result.remarks.resize(2);
  result.remarks[0].reason = "steer offsets are weak";
  result.remarks[0].remedy = "drive a tighter arc";
  result.remarks[1].reason = "segment 2 is an outlier";
  result.tied = {CalibrationParameter::kWheelbase, CalibrationParameter::kSteerGain};
  result.estimate.emplace();
  CalibrationEstimate& estimate = *result.estimate;
  estimate.calibration.base_T_laser = Pose2(0.4, 0.1, 0.2);
  for (Eigen::Index i = 0; i < 8; ++i) {
    for (Eigen::Index j = 0; j < 8; ++j) {
      estimate.covariance(i, j) = i == j ? 0.01 * static_cast<double>((i + 1) * (i + 1)) : 1e-4;
    }
  }
  estimate.intervals[3] = {0.3, 0.5};
  estimate.chi2 = 12.0;
  estimate.degrees_of_freedom = 9;
  estimate.segments.resize(2);
  estimate.segments[0].residual = Eigen::Vector3d(1e-3, 2e-3, 3e-3);
  estimate.segments[0].chi2 = 2.5;
  estimate.segments[1].used = false;
  return result;
}

TEST(CalibrationOutcomeMessage, TellsVerdictNumbersAndHowSureTheyAre) {
  const CalibrationOutcome message = to_message(some_result());
  EXPECT_EQ(message.verdict, "WEAK");
  EXPECT_EQ(message.remarks,
            (std::vector<std::string>{"steer offsets are weak: drive a tighter arc",
                                      "segment 2 is an outlier"}));
  EXPECT_EQ(message.tied, (std::vector<std::string>{"wheelbase", "steer_gain"}));
  ASSERT_EQ(message.parameters.size(), 8U);
  EXPECT_EQ(message.parameters[3].name, "laser_x");
  EXPECT_EQ(message.parameters[3].value, 0.4);
  EXPECT_NEAR(message.parameters[3].deviation, 0.4, 1e-12);
  EXPECT_EQ(message.parameters[3].high, 0.5);
  ASSERT_EQ(message.covariance.size(), 64U);
  EXPECT_EQ(message.covariance[9], 0.04);
  EXPECT_EQ(message.covariance[8], 1e-4);
  EXPECT_EQ(message.degrees_of_freedom, 9);
}

TEST(CalibrationOutcomeMessage, HasNoNumbersWhereThereAreNone) {
  CalibrationResult result = some_result();
  result.verdict = CalibrationVerdict::kUnobservable;
  result.estimate.reset();
  const CalibrationOutcome message = to_message(result);
  EXPECT_EQ(message.verdict, "UNOBSERVABLE");
  EXPECT_TRUE(message.parameters.empty());
  EXPECT_TRUE(message.covariance.empty());
}

TEST(AddReports, GoesToTheArcsThatCounted) {
  std::vector<CalibrationArc> arcs(4, to_message(some_arc()));
  add_reports(arcs, some_result(), {0, 2});
  EXPECT_EQ(arcs[0].residual.y, 2e-3);
  EXPECT_EQ(arcs[0].chi2, 2.5);
  EXPECT_TRUE(arcs[0].used);
  for (const std::size_t i : {1U, 2U, 3U}) {
    EXPECT_FALSE(arcs[i].used) << i;
    EXPECT_EQ(arcs[i].residual.x, 0.0) << i;
  }
}

}  // namespace
}  // namespace falko_slam
