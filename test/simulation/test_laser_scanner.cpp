// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/laser_scanner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/seeds.hpp"
#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace {

using test::ideal_laser;
using test::kBegin;

SimulatedScan scan_at_rest(const World& world, const LaserModel& laser, const Pose2& place = {}) {
  auto random = test::seeded_random();
  LaserScanner scanner(laser, {}, world, kBegin);
  return scanner.scan(kBegin, test::track_of(place), random);
}

TEST(LaserScanner, MeasuresTheWallInEachDirection) {
  const LaserModel laser = ideal_laser();
  const SimulatedScan scan = scan_at_rest(test::world_with_wall_at(6.0), laser, {1.0, 3.0, 0.4});

  ASSERT_EQ(scan.ranges.size(), laser.beams);
  for (std::size_t i = 0; i < laser.beams; ++i) {
    const double towards = std::cos(0.4 + test::bearing(laser, i));
    const double expected = towards > 0.0 ? 5.0 / towards : std::numeric_limits<double>::infinity();
    if (expected < 99.0) {
      EXPECT_NEAR(scan.ranges[i], expected, 2e-6 * expected) << i;
    } else if (expected > 101.0) {
      EXPECT_EQ(scan.ranges[i], 0.0F) << i;
    }
  }
}

TEST(LaserScanner, StandsWhereItIsMounted) {
  const World world = test::world_with_wall_at(6.0);
  auto random = test::seeded_random();
  LaserScanner scanner(ideal_laser(), {0.4, 0.1, 0.25}, world, kBegin);

  const SimulatedScan& scan = scanner.scan(kBegin, test::track_of({1.0, 0.0, 0.5}), random);

  const double x = 1.0 + 0.4 * std::cos(0.5) - 0.1 * std::sin(0.5);
  EXPECT_NEAR(scan.ranges[720], (6.0 - x) / std::cos(0.75), 1e-5);
}

TEST(LaserScanner, SeesTheNearestThingOnly) {
  World world = test::world_with_wall_at(6.0);
  add_box(world.fixed, {3.5, 0.0, 0.0}, {1.0, 1.0}, test::kMatt);
  world.fixed.cylinders.push_back({{2.0, 0.0}, 0.25, test::kMatt});

  const SimulatedScan scan = scan_at_rest(world, ideal_laser());

  EXPECT_NEAR(scan.ranges[720], 1.75, 1e-6);
  EXPECT_NEAR(scan.ranges[720 + 31], 3.0 / std::cos(test::bearing(ideal_laser(), 720 + 31)), 1e-5);
  EXPECT_NEAR(scan.ranges[720 + 120], 6.0 / std::cos(test::bearing(ideal_laser(), 720 + 120)),
              1e-5);
}

TEST(LaserScanner, HasTheNoiseThatTheModelStates) {
  LaserModel laser = ideal_laser();
  laser.range_noise = 0.02;
  World world = test::empty_world();
  for (int i = 0; i < 1440; ++i) {  // a round room of 8 m
    const double a = i * kTwoPi / 1440, b = (i + 1) * kTwoPi / 1440;
    world.fixed.faces.push_back(
        {{8.0 * std::cos(a), 8.0 * std::sin(a)}, {8.0 * std::cos(b), 8.0 * std::sin(b)}, 0});
  }
  const SimulatedScan scan = scan_at_rest(world, laser);

  double sum = 0.0, squares = 0.0;
  for (const float range : scan.ranges) {
    sum += range - 8.0;
    squares += (range - 8.0) * (range - 8.0);
  }
  EXPECT_NEAR(sum / 1440.0, 0.0, 4.0 * 0.02 / std::sqrt(1440.0));
  EXPECT_NEAR(std::sqrt(squares / 1440.0), 0.02, 0.02 * 4.0 / std::sqrt(2.0 * 1440.0));
}

TEST(LaserScanner, DropsBeamsAndRoundsRangesAsItIsTold) {
  LaserModel laser = ideal_laser();
  laser.drop_out = 0.1;
  laser.range_step = 0.25;
  World world = test::empty_world();
  add_box(world.fixed, {}, {10.0, 10.0}, test::kMatt);
  const SimulatedScan scan = scan_at_rest(world, laser);

  const auto dropped = std::count(scan.ranges.begin(), scan.ranges.end(), 0.0F);
  EXPECT_NEAR(static_cast<double>(dropped), 144.0, 4.0 * std::sqrt(1440.0 * 0.09));
  for (const float range : scan.ranges) EXPECT_EQ(std::fmod(range, 0.25F), 0.0F);
  for (std::size_t i = 0; i < laser.beams; ++i) {
    EXPECT_EQ(scan.ranges[i] > 0.0F, scan.intensities[i] > 0.0F) << i;
  }
}

TEST(LaserScanner, SeesDarkThingsLessFarAndNothingTooNear) {
  LaserModel laser = ideal_laser();
  laser.range_of_dark = 35.0;
  laser.nearest = 0.5;
  const auto ahead = [&](double x, std::size_t surface) {
    return scan_at_rest(test::world_with_wall_at(x, surface), laser).ranges[720];
  };

  EXPECT_NEAR(ahead(34.9, test::kDark), 34.9, 1e-4);
  EXPECT_EQ(ahead(35.1, test::kDark), 0.0F);
  EXPECT_NEAR(ahead(60.0, test::kMatt), 60.0, 1e-4);
  EXPECT_EQ(ahead(0.49, test::kMatt), 0.0F);
  EXPECT_NEAR(ahead(0.51, test::kMatt), 0.51, 1e-6);
}

TEST(LaserScanner, MixesPixelsAtEdges) {
  LaserModel laser = ideal_laser();
  laser.beam_diameter = 0.02;
  laser.beam_divergence = 0.005;
  World world = test::world_with_wall_at(5.2);
  world.fixed.faces.push_back({{5.0, -3.0}, {5.0, 0.0}, test::kMatt});  // its end is straight ahead
  const SimulatedScan scan = scan_at_rest(world, laser);

  EXPECT_GT(scan.ranges[720], 5.05F);
  EXPECT_LT(scan.ranges[720], 5.15F);
  EXPECT_NEAR(scan.ranges[710], 5.0 / std::cos(test::bearing(laser, 710)), 1e-3);
  EXPECT_NEAR(scan.ranges[730], 5.2 / std::cos(test::bearing(laser, 730)), 1e-3);
}

TEST(LaserScanner, ReflectorsAreManyTimesBrighterAndSmeared) {
  LaserModel laser;
  laser.drop_out = 0.0;
  for (const double distance : {3.0, 10.0, 25.0}) {
    World world = test::world_with_wall_at(distance + 2.0);
    world.fixed.cylinders.push_back({{distance, 0.0}, 0.04, test::kReflector});
    const SimulatedScan scan = scan_at_rest(world, laser);

    const float background = scan.intensities[700];
    const auto brightest = std::max_element(scan.intensities.begin(), scan.intensities.end());
    EXPECT_NEAR(static_cast<double>(brightest - scan.intensities.begin()), 720.0, 5.0) << distance;
    EXPECT_GT(*brightest, 5.0F * background) << distance;
    const auto bright = std::count_if(scan.intensities.begin(), scan.intensities.end(),
                                      [&](float value) { return value > 2.0F * background; });
    EXPECT_GE(bright, 2) << distance;
    // The cylinder alone, without the width of the beam, would be hit by so many.
    EXPECT_GT(static_cast<double>(bright), 0.08 / distance / laser.angle_increment) << distance;
    EXPECT_NEAR(scan.ranges[720], distance - 0.04, 0.05) << distance;
  }
}

TEST(LaserScanner, SafetyScannersHaveNoIntensities) {
  const SimulatedScan scan = scan_at_rest(test::world_with_wall_at(5.0), s300());

  EXPECT_TRUE(scan.intensities.empty());
  EXPECT_EQ(scan.ranges.size(), s300().beams);
}

TEST(LaserScanner, IsPublishedAsTheDriverDoes) {
  const LaserModel laser;
  const SimulatedScan scan = scan_at_rest(test::world_with_wall_at(5.0), laser);
  const RawScan raw = as_raw_scan(laser, scan);

  EXPECT_EQ(raw.stamp, kBegin);
  EXPECT_NEAR(raw.angle_min, -kPi, 1e-12);
  EXPECT_NEAR(raw.angle_max, kPi, 1e-12);  // one past the last beam
  EXPECT_NEAR(raw.angle_increment, degrees_to_radians(0.25), 1e-12);
  EXPECT_NEAR(raw.time_increment, 0.125 / 1440.0, 1e-12);
  EXPECT_EQ(raw.scan_time, 0.125);
  EXPECT_EQ(raw.range_min, 0.05);
  EXPECT_EQ(raw.range_max, 100.0);
  EXPECT_EQ(raw.range_count, 1440U);
  EXPECT_EQ(raw.intensity_count, 1440U);
}

}  // namespace
}  // namespace falko_slam
