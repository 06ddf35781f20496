// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/simulated_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/calibration/recorded_calibration.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

SimulatedCalibrationParams few_scans() {
  SimulatedCalibrationParams params;
  params.scans_at_rest = 3;
  params.runs = 2;
  params.calibrator.noise.common_slip = params.calibrator.noise.common_steer = 0.0;
  params.calibrator.noise.unknown_factor = 1.0;
  return params;
}

TEST(RandomHall, HasReflectorsAroundTheWayAndWallsBeyond) {
  auto random = test::seeded_random();
  const RandomHallParams params;
  const CalibrationPlan plan = plan_of(thesis_conditions()[11], few_scans());
  const TricycleParams tricycle = VehicleModel().nominal;
  for (int i = 0; i < 50; ++i) {
    const Scenario hall = random_hall(params, plan, tricycle, random);
    const auto& reflectors = hall.world.fixed.cylinders;
    EXPECT_GE(reflectors.size(), 8U);
    EXPECT_LE(reflectors.size(), 20U);
    ASSERT_EQ(hall.world.fixed.faces.size(), 4U);
    const Eigen::Vector2d middle =
        0.5 * (hall.world.fixed.faces[0].from + hall.world.fixed.faces[2].from);
    for (const Cylinder& reflector : reflectors) {
      const double distance = (reflector.center - middle).norm();
      EXPECT_GE(distance, params.min_distance - 1e-9);
      EXPECT_LE(distance, params.max_distance + 1e-9);
      for (const Pose2& end : way_of(plan, tricycle).ends) {
        const Eigen::Vector2d place = (hall.world_T_start * end).translation();
        EXPECT_GE((reflector.center - place).norm(), params.clearance - 0.1);
      }
    }
  }
}

TEST(RandomHall, SaysWhereThereIsNoRoom) {
  auto random = test::seeded_random();
  RandomHallParams params;
  params.min_distance = params.max_distance = 2.0;
  params.clearance = 10.0;
  EXPECT_THROW(
      random_hall(params, plan_of(thesis_conditions()[0], few_scans()), {1.358, 2.5e-4}, random),
      std::invalid_argument);
  params = {};
  params.min_reflectors = 2;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

// The whole chain: driver, simulator, recorder, calibrator.
TEST(SimulatedCalibration, BringsBackTheVehicle) {
  const SimulatedCalibrationParams params = few_scans();
  const CalibrationPlan plan = plan_of(thesis_conditions()[5], params);
  auto random = test::seeded_random();
  Scenario scenario = random_hall(params.hall, plan, params.vehicle.nominal, random);
  SegmentRecorderParams recorder;
  recorder.tricycle = scenario.vehicle.nominal;
  recorder.base_T_laser = scenario.vehicle.nominal_base_T_laser;

  const auto drive = drive_calibration(scenario, plan, recorder, 1);

  EXPECT_EQ(drive.trouble, "");
  ASSERT_EQ(drive.segments.size(), 16U);
  for (const RecordedSegment& segment : drive.segments) {
    EXPECT_EQ(segment.complaint, "");
    EXPECT_GE(segment.motion.scans, 6U);
  }
  const auto calibration =
      calibrate_recorded(drive.segments, params.calibrator, params.reflectors.lasting_noise);
  ASSERT_TRUE(calibration.result.estimate);
  const VehicleCalibration& found = calibration.result.estimate->calibration;
  EXPECT_NEAR(found.tricycle.driving_scale, scenario.vehicle.tricycle.driving_scale, 1e-7);
  EXPECT_NEAR(found.tricycle.steer_offset_forward, scenario.vehicle.tricycle.steer_offset_forward,
              1e-3);
  EXPECT_NEAR(found.tricycle.steer_offset_backward, scenario.vehicle.tricycle.steer_offset_backward,
              1e-3);
  EXPECT_NEAR(found.base_T_laser.x(), scenario.vehicle.base_T_laser.x(), 3e-3);
  EXPECT_NEAR(found.base_T_laser.y(), scenario.vehicle.base_T_laser.y(), 3e-3);
  EXPECT_NEAR(found.base_T_laser.theta(), scenario.vehicle.base_T_laser.theta(), 1e-3);
}

TEST(SimulatedCalibration, SaysWhyADriveWasAborted) {
  const SimulatedCalibrationParams params = few_scans();
  const CalibrationPlan plan = plan_of(thesis_conditions()[0], params);
  Scenario scenario;  // without reflectors
  scenario.world.surfaces = {{"wall", 0.5, 0.0}};
  add_box(scenario.world.fixed, {}, {40.0, 40.0}, 0);
  SegmentRecorderParams recorder;
  recorder.tricycle = scenario.vehicle.nominal;
  const auto drive = drive_calibration(scenario, plan, recorder, 1);
  EXPECT_EQ(drive.trouble, "no scans that show anything");
  EXPECT_TRUE(drive.segments.empty());
}

TEST(SimulatedCalibration, IsTheSameForAnyNumberOfThreads) {
  SimulatedCalibrationParams params = few_scans();
  const auto one = run_simulated_calibrations(thesis_conditions()[0], params);
  params.threads = 2;
  const auto two = run_simulated_calibrations(thesis_conditions()[0], params);
  EXPECT_EQ(one.runs, 2);
  EXPECT_EQ(one.runs, two.runs);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_GT(one.parameters[i].deviation, 0.0);
    EXPECT_EQ(one.parameters[i].deviation, two.parameters[i].deviation) << i;
    EXPECT_EQ(one.parameters[i].bias, two.parameters[i].bias) << i;
  }
}

TEST(SimulatedCalibration, ChecksItsParams) {
  SimulatedCalibrationParams params = few_scans();
  params.scans_at_rest = 1;
  EXPECT_THROW(run_simulated_calibrations(thesis_conditions()[0], params), std::invalid_argument);
  params = few_scans();
  params.threads = 0;
  EXPECT_THROW(run_simulated_calibrations(thesis_conditions()[0], params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
