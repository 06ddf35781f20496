// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/simulation.hpp"

#include <gtest/gtest.h>

#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace {

using test::kBegin;

Scenario room() {
  Scenario scenario;
  scenario.world = test::empty_world();
  add_box(scenario.world.fixed, {}, {20.0, 14.0}, test::kMatt);
  scenario.world.fixed.cylinders.push_back({{6.0, 3.0}, 0.04, test::kReflector});
  scenario.vehicle.errors.slip_per_run = 0.001;
  scenario.drive = {ArcStep{0.5, 0.4, 1.5, 0.0}};
  return scenario;
}

std::vector<SimulationStep> run(const Scenario& scenario, std::uint64_t seed) {
  Simulation simulation(scenario, kBegin, seed);
  const auto driver = scenario_driver(scenario.drive, scenario.vehicle);
  std::vector<SimulationStep> steps;
  while (const auto input = driver->next(simulation.vehicle(), simulation.period())) {
    steps.push_back(simulation.step(*input));
  }
  return steps;
}

TEST(Simulation, SameSeedSameResults) {
  const auto a = run(room(), 7);
  const auto b = run(room(), 7);
  const auto other = run(room(), 8);

  ASSERT_EQ(a.size(), b.size());
  bool differs = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].encoders.drive_ticks, b[i].encoders.drive_ticks);
    EXPECT_EQ(a[i].world_T_base.x(), b[i].world_T_base.x());
    ASSERT_EQ(a[i].scans.size(), b[i].scans.size());
    for (std::size_t k = 0; k < a[i].scans.size(); ++k) {
      EXPECT_EQ(a[i].scans[k].scan.ranges, b[i].scans[k].scan.ranges);
      differs = differs || a[i].scans[k].scan.ranges != other[i].scans[k].scan.ranges;
    }
  }
  EXPECT_TRUE(differs);
}

TEST(Simulation, ScansFollowEachOtherWithoutAGap) {
  const Scenario scenario = room();
  std::int64_t number = 0;
  Time end = kBegin;
  for (const SimulationStep& step : run(scenario, 1)) {
    EXPECT_EQ(step.encoders.stamp, end + std::chrono::milliseconds(20));
    end = step.encoders.stamp;
    for (const auto& scan : step.scans) {
      EXPECT_EQ(scan.scan.first_beam, kBegin + number * std::chrono::milliseconds(125));
      EXPECT_LE(scan.scan.first_beam + std::chrono::milliseconds(124), step.encoders.stamp);
      EXPECT_EQ(scan.reflectors.size(), 1U);
      ++number;
    }
  }
  const double seconds = to_seconds(end - kBegin);
  EXPECT_NEAR(static_cast<double>(number), 8.0 * seconds, 1.0);
}

TEST(Simulation, RefusesWhatIsNoScenario) {
  Scenario scenario = room();
  scenario.laser.beams = 0;
  EXPECT_THROW(Simulation(scenario, kBegin, 1), std::invalid_argument);
  scenario = room();
  scenario.vehicle.encoder_rate = 0.0;
  EXPECT_THROW(Simulation(scenario, kBegin, 1), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
