// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simulated_laser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

Scene wall_at(double x) {
  Scene scene;
  scene.walls = {{{x, -1000.0}, {x, 1000.0}}};
  return scene;
}

// All beams in one direction.
SimulatedLaserParams staring(std::size_t beams, double noise) {
  SimulatedLaserParams params;
  params.beams = beams;
  params.angle_min = 0.0;
  params.angle_increment = 0.0;
  params.noise = noise;
  return params;
}

TEST(SimulatedLaser, SeesWhatItsBeamsMeet) {
  auto random = test::seeded_random();
  SimulatedLaserParams params;
  params.beams = 90;
  params.angle_min = -1.0;
  params.angle_increment = 0.02;
  params.noise = 0.0;
  const Scene scene = office_scene();
  const Pose2 pose(-3.0, -1.0, 0.8);
  const auto ranges = simulate_ranges(scene, pose, params, random);
  ASSERT_EQ(ranges.size(), 90U);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double bearing = -1.0 + 0.02 * static_cast<double>(i);
    const double expected = scene.cast({pose.translation(), pose.theta() + bearing});
    EXPECT_NEAR(static_cast<double>(ranges[i]), expected, 1e-6 * expected) << i;
  }
}

TEST(SimulatedLaser, IsByDefaultAClosedCircle) {
  const SimulatedLaserParams params;
  EXPECT_NEAR(static_cast<double>(params.beams) * params.angle_increment, kTwoPi, 1e-12);
}

TEST(SimulatedLaser, HasTheStatedNoise) {
  auto random = test::seeded_random();
  constexpr std::size_t kBeams = 20000;
  for (const double noise : {0.01, 0.2}) {
    double mean = 0.0;
    double square = 0.0;
    for (const float range : simulate_ranges(wall_at(4.0), {}, staring(kBeams, noise), random)) {
      const double error = static_cast<double>(range) - 4.0;
      mean += error / kBeams;
      square += error * error / kBeams;
    }
    // Four standard errors of a mean, and of a standard deviation relative to itself.
    EXPECT_NEAR(mean, 0.0, 4.0 * noise / std::sqrt(kBeams));
    EXPECT_NEAR(std::sqrt(square) / noise, 1.0, 4.0 / std::sqrt(2.0 * kBeams));
  }
}

TEST(SimulatedLaser, ReportsZeroWhereNothingIsInRange) {
  auto random = test::seeded_random();
  SimulatedLaserParams params = staring(100, 0.01);
  params.range_max = 10.0;
  const std::vector<float> nothing(100, 0.0F);
  EXPECT_EQ(simulate_ranges(Scene{}, {}, params, random), nothing);
  EXPECT_EQ(simulate_ranges(wall_at(11.0), {}, params, random), nothing);
  const auto seen = simulate_ranges(wall_at(9.0), {}, params, random);
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 8.0F);
}

TEST(SimulatedLaser, NeverReportsNegativeRanges) {
  auto random = test::seeded_random();
  const auto ranges = simulate_ranges(wall_at(0.1), {}, staring(1000, 1.0), random);
  EXPECT_EQ(*std::min_element(ranges.begin(), ranges.end()), 0.0F);
}

TEST(SimulatedLaser, RepeatsWithTheSeedOfItsNoise) {
  const auto ranges = [](std::uint64_t seed) {
    std::mt19937_64 random(seed);
    return simulate_ranges(office_scene(), {-3.0, -1.0, 0.8}, staring(50, 0.01), random);
  };
  EXPECT_EQ(ranges(1), ranges(1));
  EXPECT_NE(ranges(1), ranges(2));
}

}  // namespace
}  // namespace falko_slam
