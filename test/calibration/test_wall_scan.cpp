// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/wall_scan.hpp"

#include <gtest/gtest.h>

#include "walled_halls.hpp"

namespace falko_slam {
namespace {

Scene room() {
  Scene scene;
  scene.add_box({}, {10.0, 8.0});
  return scene;
}

TEST(WallScan, FindsTheFourWallsOfARoomAcrossTheSeam) {
  auto random = test::seeded_random();
  // The seam of the scan looks at the middle of a wall.
  const WallScan walls(test::hall_laser(0.003).scan(room(), {}, {}, random), 0.003);

  // No break in the surface: the wall at the seam counts twice.
  ASSERT_EQ(walls.walls().size(), 5U);
  double length = 0.0;
  for (const WallPiece& piece : walls.pieces()) {
    length += walls.length_of(piece);
    const StraightWall& wall = walls.walls()[piece.wall];
    const bool across = std::abs(wall.normal.x()) > 0.5;
    EXPECT_NEAR(-wall.normal.dot(piece.middle), across ? 5.0 : 4.0, 0.01);
    EXPECT_LE(walls.length_of(piece), 0.8);  // the same number of beams each
  }
  EXPECT_GT(length, 28.0);
}

TEST(WallScan, LooksUpBeamsByDirection) {
  auto random = test::seeded_random();
  const WallScan walls(test::hall_laser(0.0).scan(test::walled_hall(), {}, {}, random), 0.0);

  for (const WallPiece& piece : walls.pieces()) {
    const auto beam = walls.beam_at(std::atan2(piece.middle.y(), piece.middle.x()));
    ASSERT_TRUE(beam);
    EXPECT_GE(*beam, piece.first);
    EXPECT_LE(*beam, piece.last);
    EXPECT_EQ(walls.wall_at(*beam), piece.wall);
  }
}

TEST(WallScan, KnowsNothingOutsideOfItsView) {
  auto random = test::seeded_random();
  const WallScan walls(test::hall_laser(0.0, kPi).scan(room(), {}, {}, random), 0.0);

  EXPECT_TRUE(walls.beam_at(1.5));
  EXPECT_FALSE(walls.beam_at(3.0));
}

TEST(WallScan, LeavesOutWhatIsRound) {
  auto random = test::seeded_random();
  Scene round;
  constexpr int kCorners = 200;
  for (int i = 0; i < kCorners; ++i) {
    const auto corner = [](int k) {
      return Eigen::Vector2d(3.0 * std::cos(kTwoPi * k / kCorners),
                             3.0 * std::sin(kTwoPi * k / kCorners));
    };
    round.walls.push_back({corner(i), corner(i + 1)});
  }
  WallScanParams params;
  params.min_beams = 40;
  EXPECT_TRUE(
      WallScan(test::hall_laser(0.0).scan(round, {}, {}, random), 0.0, params).walls().empty());
}

TEST(WallScan, OfNothingHasNoWalls) {
  EXPECT_TRUE(WallScan(LaserScan(), 0.01).walls().empty());
  EXPECT_FALSE(WallScan(LaserScan(), 0.01).beam_at(0.0));
  auto random = test::seeded_random();
  LaserScan blind = test::hall_laser(0.0).scan(room(), {}, {}, random);
  for (std::size_t i = 0; i < blind.size(); ++i) {
    blind.status[i] = BeamStatus::kErroneous;
    blind.ranges[i] = std::nan("");
  }
  EXPECT_TRUE(WallScan(blind, 0.01).walls().empty());
}

TEST(WallScan, RefusesBadParameters) {
  WallScanParams params;
  params.min_beams = 2;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.piece_length = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
