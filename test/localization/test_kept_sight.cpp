// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "kept_sight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kRadius = 0.06;

// All beams see a round wall 5 m away.
LaserScan round_wall(double angle_min, double degrees) {
  LaserScan scan;
  scan.angle_min = angle_min;
  scan.angle_increment = degrees_to_radians(0.5);
  const auto beams = static_cast<std::size_t>(std::lround(2.0 * degrees));
  scan.closed = degrees == 360.0;
  scan.ranges.assign(beams, 5.0);
  scan.status.assign(beams, BeamStatus::kValid);
  return scan;
}

Eigen::Vector2d place(double range, double bearing) {
  return range * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
}

TEST(KeptSight, TellsSurfacesFromWhatIsSeenThroughAndHidden) {
  for (const double angle_min : {-kPi, 0.0, 0.5 * kPi}) {
    const KeptSight sight({}, round_wall(angle_min, 360.0));
    for (double bearing = -kPi; bearing <= kPi; bearing += 0.1) {
      EXPECT_EQ(sight.at(place(5.0, bearing), kRadius), PlaceSight::kSurface) << bearing;
      EXPECT_EQ(sight.at(place(5.05, bearing), kRadius), PlaceSight::kSurface) << bearing;
      EXPECT_EQ(sight.at(place(4.9, bearing), kRadius), PlaceSight::kSeenThrough) << bearing;
      EXPECT_EQ(sight.at(place(5.1, bearing), kRadius), PlaceSight::kUnknown) << bearing;
    }
  }
}

TEST(KeptSight, KnowsWhereItStands) {
  const Pose2 map_T_laser(10.0, -3.0, 2.0);
  const KeptSight sight(map_T_laser, round_wall(-kPi, 360.0));
  EXPECT_EQ(sight.at(map_T_laser * place(5.0, 1.0), kRadius), PlaceSight::kSurface);
  EXPECT_EQ(sight.at({10.0, -1.0}, kRadius), PlaceSight::kSeenThrough);
}

TEST(KeptSight, KnowsNothingOfWhereNoBeamLooks) {
  const KeptSight sight({}, round_wall(-0.75 * kPi, 270.0));
  EXPECT_EQ(sight.at(place(5.0, 0.7 * kPi), kRadius), PlaceSight::kSurface);
  EXPECT_EQ(sight.at(place(5.0, 0.9 * kPi), kRadius), PlaceSight::kUnknown);
  EXPECT_EQ(sight.at(place(4.0, -0.9 * kPi), kRadius), PlaceSight::kUnknown);
  EXPECT_EQ(sight.at({0.0, 0.0}, kRadius), PlaceSight::kUnknown);
}

TEST(KeptSight, OneBeamThatSawNothingLeavesItOpen) {
  LaserScan scan = round_wall(-kPi, 360.0);
  scan.ranges[360] = std::numeric_limits<double>::quiet_NaN();
  const KeptSight sight({}, scan);
  EXPECT_EQ(sight.at({4.0, 0.0}, kRadius), PlaceSight::kUnknown);
  EXPECT_EQ(sight.at({5.0, 0.0}, kRadius), PlaceSight::kSurface);
}

TEST(KeptSight, BeamsTooFarApartTellNothing) {
  LaserScan scan = round_wall(-kPi, 360.0);
  scan.ranges.assign(scan.size(), 50.0);
  const KeptSight sight({}, scan);
  EXPECT_EQ(sight.at({5.0, 0.0}, kRadius), PlaceSight::kSeenThrough);
  EXPECT_EQ(sight.at({20.0, 0.0}, kRadius), PlaceSight::kUnknown);
}

}  // namespace
}  // namespace falko_slam
