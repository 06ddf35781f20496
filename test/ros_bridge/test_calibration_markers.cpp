// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_markers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/times.hpp"

namespace falko_slam {
namespace {

using visualization_msgs::Marker;

// A vehicle that has gone 2 m ahead from (10, 5), looking along y; its laser sits 1 m before it.
class Drawn : public ::testing::Test {
 protected:
  Drawn() : markers_(params(), Pose2(10.0, 5.0, M_PI / 2.0)) {
    markers_.add_pose(test::at_seconds(1), Pose2());
    markers_.add_pose(test::at_seconds(2), Pose2(2.0, 0.0, 0.0));
  }
  static CalibrationSessionParams params() {
    CalibrationSessionParams params;
    params.recorder.base_T_laser = Pose2(1.0, 0.0, 0.0);
    return params;
  }
  static std::vector<SessionArc> arcs() {
    std::vector<SessionArc> arcs(2);
    arcs[0].recorded.end = test::at_seconds(2);
    arcs[0].residual = Eigen::Vector3d(0.01, 0.0, 0.0);
    arcs[1].recorded.complaint = "no reflectors";
    return arcs;
  }
  std::vector<Marker> drawn() const {
    std_msgs::Header header;
    header.frame_id = "odom";
    return markers_.markers(header).markers;
  }

  CalibrationMarkers markers_;
};

TEST_F(Drawn, ShowsWhatIsPlannedAndDriven) {
  const std::vector<Marker> markers = drawn();
  EXPECT_EQ(markers[0].ns, "planned");
  EXPECT_EQ(markers[0].header.frame_id, "odom");
  EXPECT_GT(markers[0].points.size(), 24U * 36U);
  EXPECT_EQ(markers[0].points.front().x, 10.0);
  EXPECT_EQ(markers[1].ns, "driven");
  ASSERT_EQ(markers[1].points.size(), 2U);
  EXPECT_NEAR(markers[1].points[1].y, 7.0, 1e-12);
}

TEST_F(Drawn, KnowsTheNewestPoseAndFewOfTheOthers) {
  for (int i = 1; i <= 1000; ++i)
    markers_.add_pose(test::at_seconds(2 + i), Pose2(2.0 + 1e-3 * i, 0.0, 0.0));
  const Marker driven = drawn()[1];
  EXPECT_NEAR(driven.points.back().y, 8.0, 1e-12);
  EXPECT_LT(driven.points.size(), 15U);
}

TEST_F(Drawn, ShowsReflectorsWhereTheyAre) {
  ReflectorObservation observation;
  observation.first_beam = test::at_seconds(3);
  observation.reflectors = {{{4.0, 1.0}, Duration::zero()}};
  markers_.set_reflectors(observation);
  const Marker reflectors = drawn()[2];
  EXPECT_EQ(reflectors.action, Marker::ADD);
  ASSERT_EQ(reflectors.points.size(), 1U);
  EXPECT_NEAR(reflectors.points[0].x, 9.0, 1e-12);
  EXPECT_NEAR(reflectors.points[0].y, 12.0, 1e-12);
}

TEST_F(Drawn, KnowsWhereItHalted) {
  for (int i = 3; i < 10; ++i) markers_.add_pose(test::at_seconds(i), Pose2(2.0, 0.0, 0.015));
  ReflectorObservation observation;
  observation.first_beam = test::at_seconds(8);
  observation.reflectors = {{{9.0, 0.0}, Duration::zero()}};
  markers_.set_reflectors(observation);
  EXPECT_NEAR(drawn()[2].points.at(0).x, 10.0 - 10.0 * std::sin(0.015), 1e-12);
}

TEST_F(Drawn, ShowsResidualsWhereTheArcsEnd) {
  markers_.set_arcs(arcs());
  const Marker believed = drawn()[3];
  ASSERT_EQ(believed.points.size(), 6U);
  EXPECT_NEAR(believed.points[0].x, 10.0, 1e-12);
  EXPECT_NEAR(believed.points[0].y, 8.0, 1e-12);
  EXPECT_NEAR(believed.points[1].y, 8.0 + 0.01 * CalibrationMarkers::kBelievedScale, 1e-12);
  EXPECT_EQ(drawn()[4].action, Marker::DELETE);
}

TEST_F(Drawn, ShowsWhatTheResultSaysAndWhatWasLeftOut) {
  markers_.set_arcs(arcs());
  RecordedCalibration calibration;
  calibration.recorded = {0};
  calibration.result.estimate.emplace();
  calibration.result.estimate->segments.resize(1);
  calibration.result.estimate->segments[0].residual.x() = 0.002;
  markers_.set_result(calibration);
  EXPECT_EQ(drawn()[3].action, Marker::DELETE);
  const Marker calibrated = drawn()[4];
  ASSERT_EQ(calibrated.points.size(), 6U);
  EXPECT_NEAR(calibrated.points[1].y, 8.0 + 0.002 * CalibrationMarkers::kResidualScale, 1e-12);
  calibration.result.estimate->segments[0].used = false;
  markers_.set_result(calibration);
  EXPECT_EQ(drawn()[4].action, Marker::DELETE);
  EXPECT_EQ(drawn()[5].action, Marker::ADD);
}

}  // namespace
}  // namespace falko_slam
