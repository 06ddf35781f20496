// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_session.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "session_drive.hpp"

namespace falko_slam {
namespace {

using test::SessionDrive;

class Session : public ::testing::Test {
 protected:
  CalibrationSessionParams params_ = test::short_session(SessionDrive::kModel);
  CalibrationSession session_{params_};
  SessionDrive drive_{session_};
};

TEST_F(Session, LeadsFromTheFirstCommandToTheVehicle) {
  ASSERT_TRUE(drive_.drive_until([&] { return session_.over(); }));
  ASSERT_TRUE(session_.driver().done()) << session_.driver().reason();
  const RecordedCalibration calibration = session_.evaluate();

  ASSERT_EQ(session_.arcs().size(), 8U);
  ASSERT_TRUE(calibration.result.estimate);
  const VehicleCalibration& found = calibration.result.estimate->calibration;
  const VehicleModel& truth = SessionDrive::kModel;
  EXPECT_NEAR(found.tricycle.driving_scale, truth.tricycle.driving_scale, 1e-8);
  EXPECT_NEAR(found.tricycle.steer_offset_forward, truth.tricycle.steer_offset_forward, 1e-4);
  EXPECT_NEAR(found.tricycle.steer_offset_backward, truth.tricycle.steer_offset_backward, 1e-4);
  EXPECT_NEAR(found.base_T_laser.x(), truth.base_T_laser.x(), 2e-4);
  EXPECT_NEAR(found.base_T_laser.y(), truth.base_T_laser.y(), 2e-4);
  EXPECT_NEAR(found.base_T_laser.theta(), truth.base_T_laser.theta(), 1e-4);
}

TEST_F(Session, TellsByWhatAnArcIsOffTheBelieved) {
  ASSERT_TRUE(drive_.drive_until([&] { return session_.arcs().size() == 2; }));
  const SessionArc& arc = session_.arcs().front();
  ASSERT_TRUE(arc.residual) << arc.recorded.complaint;
  const VehicleModel& model = SessionDrive::kModel;
  const PathSegment& segment = arc.recorded.segment;
  const Pose2 base = drive_arc(model.nominal, segment.ticks, segment.steering);
  const Pose2 laser = model.nominal_base_T_laser.inverse() * base * model.nominal_base_T_laser;
  const Pose2& seen = segment.start_T_end.pose;
  EXPECT_NEAR(arc.residual->x(), seen.x() - laser.x(), 1e-9);
  EXPECT_NEAR(arc.residual->y(), seen.y() - laser.y(), 1e-9);
  EXPECT_NEAR(arc.residual->z(), segment.turn - laser.theta(), 1e-9);
  EXPECT_GT(arc.residual->head<2>().norm(), 0.01);
}

TEST_F(Session, KnowsWhenTheVehicleStands) {
  ASSERT_TRUE(drive_.drive_until([&] { return drive_.vehicle().wheel_speed() > 0.5; }));
  session_.abort("enough");
  EXPECT_TRUE(session_.over());
  const Duration since = std::chrono::milliseconds(300);
  EXPECT_FALSE(session_.stands(drive_.vehicle().time(), since));
  ASSERT_TRUE(drive_.drive_until([&] { return drive_.vehicle().wheel_speed() == 0.0; }));
  EXPECT_FALSE(session_.stands(drive_.vehicle().time(), since));
  for (int i = 0; i < 20; ++i) drive_.step();
  EXPECT_TRUE(session_.stands(drive_.vehicle().time(), since));
  EXPECT_EQ(session_.driver().reason(), "enough");
}

TEST_F(Session, EndsWhenTooManyArcsGiveNothing) {
  params_.max_bad_arcs = 1;
  params_.recorder.reflectors.min_reflectors = 10;  // there are nine
  CalibrationSession blind(params_);
  SessionDrive drive(blind);
  ASSERT_TRUE(drive.drive_until([&] { return blind.over(); }));
  EXPECT_NE(blind.driver().reason().find("too many arcs without a measurement"), std::string::npos)
      << blind.driver().reason();
  EXPECT_EQ(blind.arcs().size(), 2U);
  EXPECT_EQ(drive.command.wheel_speed, 0.0);
  EXPECT_FALSE(blind.arcs().front().residual);
}

TEST_F(Session, HasNoNumberAfterOnePhase) {
  ASSERT_TRUE(drive_.drive_until([&] { return session_.arcs().size() == 2; }));
  session_.abort("enough");
  const RecordedCalibration calibration = session_.evaluate();
  EXPECT_EQ(calibration.result.verdict, CalibrationVerdict::kUnobservable);
  EXPECT_FALSE(calibration.result.estimate);
}

TEST(CalibrationSessionParams, AreCheckedBeforeAnythingMoves) {
  CalibrationSessionParams params = test::short_session(SessionDrive::kModel);
  params.max_bad_arcs = -1;
  EXPECT_THROW(CalibrationSession{params}, std::invalid_argument);
  params = test::short_session(SessionDrive::kModel);
  params.plan.max_distance = 1.0;
  EXPECT_THROW(CalibrationSession{params}, std::invalid_argument);
  params = test::short_session(SessionDrive::kModel);
  params.recorder.settling = -1.0;
  EXPECT_THROW(CalibrationSession{params}, std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
