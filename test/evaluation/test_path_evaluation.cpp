// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/path_evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "falko_slam/evaluation/surveyed_map.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// A lane of pallets, reflectors at its mouth; 8 m in.
Scenario lane() {
  Scenario scenario;
  scenario.world.surfaces = {{"cardboard", 0.6, 0.0}, {"reflector", 0.3, 500.0}};
  std::mt19937_64 random = test::seeded_random();
  for (int i = 0; i < 14; ++i) {
    for (const double y : {-1.8, 1.8}) {
      const double x = 0.92 * i + test::uniform(random, -0.02, 0.02);
      add_box(scenario.world.fixed,
              {x, y + test::uniform(random, -0.02, 0.02), test::uniform(random, -0.01, 0.01)},
              {0.8, 1.2}, 0);
    }
  }
  add_box(scenario.world.fixed, {13.5, 0.0, 0.0}, {0.8, 1.2}, 0);
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(-4, 3), {-3, -4}, {-6, 0.5}, {-5, -2}}) {
    scenario.world.fixed.cylinders.push_back({at, 0.04, 1});
  }
  scenario.vehicle.errors.steering_per_run = 5e-4;
  scenario.vehicle.errors.slip_per_run = 1e-3;
  FollowStep in;
  in.through = {{8.0, 0.0}};
  in.name = "lane";
  in.reflectors_until = 1.0;
  scenario.drive = {WaitStep{1.0}, in, WaitStep{1.0}};
  return scenario;
}

TEST(PathEvaluation, LandmarksInTheStateCarryThePoseWhereOdometryDrifts) {
  const Scenario scenario = lane();
  const SimulatedDrive drive = simulate_drive(scenario, {}, {}, 5, 600.0);
  ASSERT_EQ(drive.legs.size(), 1U);
  EXPECT_LT(drive.legs[0].reflectors_until, drive.legs[0].end);
  std::mt19937_64 random = test::seeded_random();
  const LandmarkMap map = surveyed_map(scenario.world, 0.0, random);
  LocalizerParams params;
  const auto runs = evaluate_paths(drive, PathMethod::kState, params, map);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].path, "lane");
  EXPECT_TRUE(is_within(runs[0]));
  EXPECT_NEAR(runs[0].errors.back().way, 8.0, 0.2);
  const auto odometry = evaluate_paths(drive, PathMethod::kOdometry, params, map);
  const auto external = evaluate_paths(drive, PathMethod::kExternalMap, params, map);
  const auto off = [](const PathRun& run) { return std::abs(run.errors.back().heading); };
  EXPECT_LT(off(runs[0]), off(odometry[0]));
  // It takes its landmarks for sure, and so itself.
  EXPECT_GT(external[0].nees, 2.0 * runs[0].nees);
}

TEST(PathEvaluation, ARunThatDoesNotArriveIsNotWithin) {
  PathRun run;
  run.errors = {{1.0, 0.0, 0.0, 0.0}};
  EXPECT_FALSE(is_within(run));
  run.arrived = true;
  EXPECT_TRUE(is_within(run));
  run.errors.back().across = 0.021;
  EXPECT_FALSE(is_within(run));
}

}  // namespace
}  // namespace falko_slam
