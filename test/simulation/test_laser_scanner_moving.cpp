// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What motion does to a scan, and that it can be undone.
#include <gtest/gtest.h>

#include <cmath>

#include "falko_slam/sensor/deskew.hpp"
#include "falko_slam/simulation/laser_scanner.hpp"
#include "support/seeds.hpp"
#include "support/simulated_worlds.hpp"

namespace falko_slam {
namespace {

using test::ideal_laser;
using test::kBegin;

SimulatedScan scan_on_arc(const World& world, const LaserModel& laser, const Pose2& start,
                          const Eigen::Vector3d& tangent) {
  auto random = test::seeded_random();
  LaserScanner scanner(laser, {}, world, kBegin);
  return scanner.scan(kBegin, test::track_of(start, tangent), random);
}

TEST(LaserScannerMoving, TurningOnTheSpotSkewsTheBearings) {
  const LaserModel laser = ideal_laser();
  constexpr double kTurnRate = 0.6;
  const SimulatedScan scan =
      scan_on_arc(test::world_with_wall_at(4.0), laser, {}, {0.0, 0.0, kTurnRate});

  for (std::size_t i = 500; i < 900; ++i) {
    const double turned = kTurnRate * static_cast<double>(i) * laser.time_increment;
    const double towards = std::cos(test::bearing(laser, i) + turned);
    EXPECT_NEAR(scan.ranges[i], 4.0 / towards, 1e-5 * scan.ranges[i]) << i;
  }
}

TEST(LaserScannerMoving, DrivingAtAWallShortensItsRanges) {
  const LaserModel laser = ideal_laser();
  const SimulatedScan scan =
      scan_on_arc(test::world_with_wall_at(10.0), laser, {}, {1.5, 0.0, 0.0});

  for (std::size_t i = 500; i < 900; ++i) {
    const double driven = 1.5 * static_cast<double>(i) * laser.time_increment;
    EXPECT_NEAR(scan.ranges[i], (10.0 - driven) / std::cos(test::bearing(laser, i)),
                1e-5 * scan.ranges[i])
        << i;
  }
}

// Distance of the wall's points from the wall, root mean square [m].
double wall_error(const LaserScan& scan, const Pose2& world_T_laser, double x) {
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!scan.valid(i) || std::abs(scan.bearing(i)) > 1.0) continue;
    const double error = (world_T_laser * scan.point(i)).x() - x;
    squares += error * error;
    ++count;
  }
  EXPECT_GT(count, 300);
  return std::sqrt(squares / count);
}

TEST(LaserScannerMoving, TrueMotionGivesTheStraightWallBackToWithinNoise) {
  LaserModel laser;
  laser.drop_out = 0.0;
  const Eigen::Vector3d tangent(1.2, 0.0, 0.7);
  const Pose2 start(0.0, 0.0, -0.04);
  const SimulatedScan raw = scan_on_arc(test::world_with_wall_at(5.0), laser, start, tangent);
  LaserScan scan;
  normalize(as_raw_scan(laser, raw), {}, scan);

  const double skewed = wall_error(scan, start, 5.0);
  const double period = laser.scan_period;
  const LaserScan straight =
      deskew(scan, {Pose2::exp(period * tangent), from_seconds(period)}, kBegin);

  // Of a slanted beam the noise of its direction counts, too.
  const double slant = 5.0 * laser.bearing_noise * std::tan(1.0) / std::cos(1.0);
  const double noise = std::hypot(laser.range_noise, slant);
  EXPECT_LT(wall_error(straight, start, 5.0), 1.2 * noise);
  EXPECT_GT(skewed, 5.0 * noise);
}

TEST(LaserScannerMoving, TheSameSeedGivesTheSameScan) {
  const World world = test::world_with_wall_at(5.0);
  const SimulatedScan a = scan_on_arc(world, {}, {}, {1.0, 0.0, 0.3});
  const SimulatedScan b = scan_on_arc(world, {}, {}, {1.0, 0.0, 0.3});

  EXPECT_EQ(a.ranges, b.ranges);
  EXPECT_EQ(a.intensities, b.intensities);
}

}  // namespace
}  // namespace falko_slam
