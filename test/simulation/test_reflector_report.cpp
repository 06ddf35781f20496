// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/reflector_report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/seeds.hpp"
#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace {

using test::kBegin;

struct Seen {
  SimulatedScan scan;
  std::vector<ReflectorDetection> reflectors;
};

Seen look(const World& world, const LaserModel& laser) {
  auto random = test::seeded_random();
  LaserScanner scanner(laser, {}, world, kBegin);
  Seen seen;
  seen.scan = scanner.scan(kBegin, test::track_of({}), random);
  seen.reflectors = report_reflectors(laser, seen.scan, 0.08);
  return seen;
}

World room_with_reflectors(const std::vector<Eigen::Vector2d>& centers) {
  World world = test::empty_world();
  add_box(world.fixed, {}, {60.0, 60.0}, test::kMatt);
  for (const Eigen::Vector2d& center : centers) {
    world.fixed.cylinders.push_back({center, 0.04, test::kReflector});
  }
  return world;
}

Eigen::Vector2d position(const ReflectorDetection& found) {
  return found.range * Eigen::Vector2d(std::cos(found.bearing), std::sin(found.bearing));
}

TEST(ReflectorReport, FindsEachReflectorOnceWhereItIs) {
  const std::vector<Eigen::Vector2d> centers = {
      {3.0, 1.0}, {0.5, 8.0}, {-12.0, 5.0}, {-4.0, -15.0}, {20.0, -3.0}};
  const Seen seen = look(room_with_reflectors(centers), {});

  ASSERT_EQ(seen.reflectors.size(), centers.size());
  for (const Eigen::Vector2d& center : centers) {
    double nearest = 1e9;
    for (const ReflectorDetection& found : seen.reflectors) {
      nearest = std::min(nearest, (position(found) - center).norm());
    }
    EXPECT_LT(nearest, 0.01 + 0.002 * center.norm()) << center.transpose();
  }
}

TEST(ReflectorReport, IsOneReflectorAcrossTheSeam) {
  const Seen seen = look(room_with_reflectors({{-6.0, 0.0}}), {});

  ASSERT_EQ(seen.reflectors.size(), 1U);
  EXPECT_GT(seen.reflectors[0].first_beam, seen.reflectors[0].last_beam);
  EXPECT_LT((position(seen.reflectors[0]) - Eigen::Vector2d(-6.0, 0.0)).norm(), 0.03);
}

TEST(ReflectorReport, TellsItsBeamsTimeAndBrightness) {
  const LaserModel laser;
  const Seen seen = look(room_with_reflectors({{5.0, 0.0}}), laser);

  ASSERT_EQ(seen.reflectors.size(), 1U);
  const ReflectorDetection& found = seen.reflectors[0];
  EXPECT_EQ(found.hits, found.last_beam - found.first_beam + 1);
  EXPECT_NEAR(found.time_offset, 0.5 * laser.scan_period, 0.001);
  double sum = 0.0;
  for (std::size_t i = found.first_beam; i <= found.last_beam; ++i) {
    sum += static_cast<double>(seen.scan.intensities[i]);
  }
  EXPECT_NEAR(found.mean_intensity, sum / static_cast<double>(found.hits), 1e-6 * sum);
}

TEST(ReflectorReport, FindsNoneWhereNoneIs) {
  EXPECT_TRUE(look(room_with_reflectors({}), {}).reflectors.empty());
  World bright = test::world_with_wall_at(1.0);
  bright.surfaces[0].reflectivity = 1.0;
  EXPECT_TRUE(look(bright, {}).reflectors.empty());
}

TEST(ReflectorReport, NeedsIntensities) {
  LaserModel laser;
  laser.intensities = false;
  EXPECT_TRUE(look(room_with_reflectors({{5.0, 0.0}}), laser).reflectors.empty());
}

}  // namespace
}  // namespace falko_slam
