// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/layout_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "falko_slam/evaluation/soak.hpp"
#include "falko_slam/evaluation/surveyed_map.hpp"
#include "support/plants.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

VehicleCalibration truth_of(const VehicleModel& model) {
  return {model.tricycle, 1.0, model.base_T_laser};
}

LandmarkMap map_of(const World& world) {
  std::mt19937_64 random = test::seeded_random();
  return surveyed_map(world, 0.0, random);
}

double distance(const HaltingPoint& point) {
  return (point.world_T_base.translation() - point.halt.map_T_planned.translation()).norm();
}

TEST(LayoutDrive, HaltsWhereItShouldInTruth) {
  const Scenario plant = test::small_plant();
  const LayoutDrive drive =
      drive_layout(plant, test::lap(), truth_of(plant.vehicle), {}, {}, map_of(plant.world), 3);
  EXPECT_EQ(drive.trouble, "");
  ASSERT_EQ(drive.halts.size(), 2U);
  for (const HaltingPoint& point : drive.halts) EXPECT_LT(distance(point), 0.012);
  EXPECT_LT(drive.cross_track_rmse, 0.01);
}

TEST(LayoutDrive, OfAVehicleTakenForAnotherHaltsElsewhere) {
  const Scenario plant = test::small_plant();
  VehicleCalibration wrong = truth_of(plant.vehicle);
  wrong.base_T_laser = wrong.base_T_laser * Pose2(0.0, 0.04, 0.0);
  const LandmarkMap map = map_of(plant.world);
  const LayoutDrive right =
      drive_layout(plant, test::lap(), truth_of(plant.vehicle), {}, {}, map, 3);
  const LayoutDrive off = drive_layout(plant, test::lap(), wrong, {}, {}, map, 3);
  ASSERT_FALSE(off.halts.empty());
  EXPECT_GT(distance(off.halts[0]), distance(right.halts[0]) + 0.02);
}

TEST(LayoutDrive, OfABlindVehicleEnds) {
  Scenario plant = test::small_plant();
  const LandmarkMap map = map_of(plant.world);
  plant.world.fixed.cylinders.clear();
  LocalizerParams params;
  params.features.unmapped = false;
  params.monitor.lost_position = params.monitor.ok_position;  // it does not trust its wheels far
  const LayoutDrive drive =
      drive_layout(plant, test::lap(), truth_of(plant.vehicle), params, {}, map, 3);
  EXPECT_NE(drive.trouble.find("no pose for 30 s"), std::string::npos) << drive.trouble;
  EXPECT_TRUE(drive.halts.empty());
}

TEST(Soak, TellsEachPeriodOfItsDrive) {
  const Scenario plant = test::small_plant();
  SoakParams params;
  params.hours = 0.04;
  params.period_minutes = 1.2;
  std::vector<SoakPeriod> periods;
  const std::string trouble = soak(plant, test::lap(), map_of(plant.world), params,
                                   [&](const SoakPeriod& period) { periods.push_back(period); });
  EXPECT_EQ(trouble, "");
  ASSERT_EQ(periods.size(), 2U);
  EXPECT_NEAR(periods[1].end, 144.0, 1.0);
  for (const SoakPeriod& period : periods) {
    EXPECT_NEAR(static_cast<double>(period.scans), 72.0 / plant.laser.scan_period, 12.0);
    EXPECT_LT(period.position_rmse, 0.01);
    EXPECT_GE(period.position_max, period.position_rmse);
  }
  EXPECT_GT(periods[0].halts, 0U);
}

TEST(Soak, RefusesBadParameters) {
  SoakParams params;
  params.hours = -1.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
