// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/precision_evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "falko_slam/evaluation/surveyed_map.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/plants.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

TEST(ThesisVehicles, AreThreeOfTable53AndOneAsBuilt) {
  const std::vector<PrecisionVehicle> vehicles = thesis_vehicles();
  ASSERT_EQ(vehicles.size(), 4U);
  EXPECT_EQ(vehicles[0].name, "LGV71");
  EXPECT_NEAR(vehicles[0].model.base_T_laser.theta(), degrees_to_radians(2.3649), 1e-12);
  EXPECT_NEAR(vehicles[2].model.tricycle.driving_scale, 2.49122e-4, 1e-12);
  EXPECT_FALSE(vehicles[3].calibrated);
  EXPECT_EQ(vehicles[3].model.tricycle.driving_scale, vehicles[1].model.tricycle.driving_scale);
}

TEST(Precision, OfACalibratedVehicleIsOfMillimetres) {
  const Scenario plant = test::small_plant();
  std::mt19937_64 random = test::seeded_random();
  const LandmarkMap map = surveyed_map(plant.world, 0.0, random);
  PrecisionParams params;
  params.condition = {4, 0.314, 0.873, kPi, 1.0};
  const PrecisionRun run =
      evaluate_precision(thesis_vehicles()[0], 0, plant, test::lap(), map, params);
  EXPECT_EQ(run.drive.trouble, "");
  const VehicleModel& truth = run.vehicle.model;
  EXPECT_NEAR(run.believed.base_T_laser.x(), truth.base_T_laser.x(), 3e-3);
  EXPECT_NEAR(run.believed.base_T_laser.theta(), truth.base_T_laser.theta(), 2e-3);
  ASSERT_EQ(run.drive.halts.size(), 2U);
  for (const LocalHalt& halt : local_halts({run})) {
    EXPECT_LT(halt.planned, 0.015);
    EXPECT_EQ(halt.distance(), 0.0);  // the only one is the mean
  }
}

HaltingPoint halted(double x, double y) {
  HaltingPoint point;
  point.halt.name = "A";
  point.halt.map_T_planned = {1.0, 2.0, kPi / 2.0};
  point.world_T_base = {x, y, kPi / 2.0 + 0.01};
  return point;
}

TEST(LocalHalts, AreSeenFromTheMeanOfTheCalibratedVehicles) {
  std::vector<PrecisionRun> runs(3);
  runs[0].drive.halts = {halted(1.0, 2.010)};
  runs[1].drive.halts = {halted(1.0, 1.990)};
  runs[2].drive.halts = {halted(0.9, 2.0)};
  runs[2].vehicle.calibrated = false;
  const std::vector<LocalHalt> halts = local_halts(runs);
  ASSERT_EQ(halts.size(), 3U);
  EXPECT_NEAR(halts[0].x, 0.01, 1e-12);  // ahead, which is the map's y
  EXPECT_NEAR(halts[0].y, 0.0, 1e-12);
  EXPECT_NEAR(halts[0].heading, 0.01, 1e-12);
  EXPECT_NEAR(halts[0].planned, 0.01, 1e-12);
  EXPECT_NEAR(halts[2].y, 0.1, 1e-12);
  EXPECT_NEAR(halts[2].distance(), 0.1, 1e-12);
}

TEST(LocalHalts, LeaveOutWhereNoCalibratedVehicleHalted) {
  std::vector<PrecisionRun> runs(1);
  runs[0].vehicle.calibrated = false;
  runs[0].drive.halts = {halted(0.0, 0.0)};
  EXPECT_TRUE(local_halts(runs).empty());
}

}  // namespace
}  // namespace falko_slam
