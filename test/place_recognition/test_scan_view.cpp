// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/scan_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/hand_made_scans.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

using test::kNoRange;

// A wall of 4 m, 2 m to the left, and nothing else.
Scene single_wall() {
  Scene scene;
  scene.walls = {{{-2.0, 2.0}, {2.0, 2.0}}};
  return scene;
}

ScanView view_of(const Scene& scene, std::size_t beams, double noise,
                 const ScanViewParams& params = {}) {
  auto random = test::seeded_random();
  return ScanView(test::closed_scan(scene, {}, beams, noise, random), params);
}

double sum_of_lengths(const ScanView& view) {
  double sum = 0.0;
  for (const SurfacePoint& point : view.points()) sum += point.length;
  return sum;
}

TEST(ScanView, NormalsPointFromTheWallToTheLaser) {
  const ScanView view = view_of(single_wall(), 720, 0.0);
  ASSERT_FALSE(view.points().empty());
  for (const SurfacePoint& point : view.points()) {
    EXPECT_LT((point.normal - Eigen::Vector2d(0.0, -1.0)).norm(), 1e-6);
  }
}

TEST(ScanView, NormalsAreOfUnitLengthAndFaceTheLaserInAnyRoom) {
  const ScanView view = view_of(test::room_with_pillar(), 720, 0.01);
  for (const SurfacePoint& point : view.points()) {
    if (point.normal.isZero(0.0)) continue;
    EXPECT_NEAR(point.normal.norm(), 1.0, 1e-12);
    EXPECT_LE(point.normal.dot(point.position), 0.0);
  }
}

// Beams of 0.25 degrees are less than their noise apart on this wall. Over a reach of 0.1 m to both
// sides the ends' noise turns the normal by sqrt(2) 0.01 / 0.2 rad; four of these.
TEST(ScanView, NormalsStandNoiseOfBeamsThatAreClose) {
  const ScanView view = view_of(single_wall(), 1440, 0.01);
  for (const SurfacePoint& point : view.points()) {
    if (std::abs(point.position.x()) > 1.8) continue;  // the reach ends with the wall
    const double turn = std::atan2(point.normal.x(), -point.normal.y());
    EXPECT_LT(std::abs(turn), 4.0 * std::sqrt(2.0) * 0.01 / 0.2) << point.position.x();
  }
}

TEST(ScanView, LengthsAddUpToTheWall) {
  for (const std::size_t beams : {180U, 720U, 1440U}) {
    // Both ends of the wall lie up to a step of the beams, at most 4 / sin(45) 2 pi / beams, off.
    const double step = std::hypot(2.0, 2.0) * std::sqrt(2.0) * kTwoPi / static_cast<double>(beams);
    EXPECT_NEAR(sum_of_lengths(view_of(single_wall(), beams, 0.0)), 4.0, 2.0 * step) << beams;
  }
}

// A point is the mean of beams within the spacing of the first; the next one begins beyond it.
TEST(ScanView, PointsAreAboutTheSpacingApart) {
  for (const double spacing : {0.05, 0.10, 0.30}) {
    ScanViewParams params;
    params.point_spacing = spacing;
    const ScanView view = view_of(single_wall(), 1440, 0.0, params);
    ASSERT_GT(view.points().size(), 10U);
    for (std::size_t i = 1; i + 1 < view.points().size(); ++i) {
      const double step = (view.points()[i].position - view.points()[i - 1].position).norm();
      EXPECT_GT(step, 0.7 * spacing);
      EXPECT_LT(step, 1.7 * spacing);
    }
  }
}

TEST(ScanView, PointsLieOnTheWallWithLessNoiseThanBeams) {
  const ScanView view = view_of(single_wall(), 1440, 0.01);
  double squares = 0.0;
  for (const SurfacePoint& point : view.points()) {
    const double off = point.position.y() - 2.0;
    squares += off * off;
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(view.points().size())), 0.015);
}

TEST(ScanView, SpacingLosesNoLength) {
  ScanViewParams all;
  all.point_spacing = 0.0;
  const double length = sum_of_lengths(view_of(test::room_with_pillar(), 720, 0.01, all));
  EXPECT_GT(length, 0.0);
  EXPECT_NEAR(sum_of_lengths(view_of(test::room_with_pillar(), 720, 0.01)), length, 1e-9);
}

TEST(ScanView, FindsTheBeamOfItsBearing) {
  for (const LaserScan& scan :
       {test::round_scan(3.0, 36), test::scan_of({1.0, 2.0, 3.0, 4.0}, -0.4, 0.25)}) {
    const ScanView view(scan);
    for (std::size_t beam = 0; beam < scan.size(); ++beam) {
      for (const double off : {-0.4 * scan.angle_increment, 0.0, 0.4 * scan.angle_increment}) {
        for (const double turn : {-kTwoPi, 0.0, kTwoPi}) {
          EXPECT_EQ(view.beam_at(scan.bearing(beam) + off + turn), beam);
        }
      }
    }
  }
}

TEST(ScanView, AClosedScanLooksEverywhere) {
  const ScanView view(test::round_scan(3.0, 36));
  EXPECT_EQ(view.beam_at(-kPi), 0U);
  EXPECT_EQ(view.beam_at(kPi), 0U);
  EXPECT_EQ(view.beam_at(std::nextafter(kPi, 0.0)), 0U);
  EXPECT_EQ(view.beam_at(kPi - 0.9 * kTwoPi / 36.0), 35U);
}

TEST(ScanView, AnOpenScanLooksHalfABeamBeyondItsEnds) {
  const ScanView view(test::scan_of({1.0, 1.0, 1.0}, -0.5, 0.5));
  EXPECT_EQ(view.beam_at(-0.74), 0U);
  EXPECT_FALSE(view.beam_at(-0.76));
  EXPECT_EQ(view.beam_at(0.74), 2U);
  EXPECT_FALSE(view.beam_at(0.76));
  EXPECT_FALSE(view.beam_at(-kPi));
  EXPECT_FALSE(view.beam_at(kPi));
}

TEST(ScanView, BeamsThatAreNotValidHaveNoRangeAndNoSurface) {
  const ScanView view(test::circle_of({2.0, kNoRange, 2.0, 2.0}));
  EXPECT_EQ(view.range(0), 2.0);
  EXPECT_EQ(view.range(1), 0.0);
  EXPECT_EQ(view.surface(1).length, 0.0);
  EXPECT_EQ(view.points().size(), 3U);
}

TEST(ScanView, FarBeamsHaveARangeButNoSurface) {
  const ScanView view(test::circle_of({2.0, 50.0, 2.0, 2.0}));
  EXPECT_EQ(view.range(1), 50.0);
  EXPECT_EQ(view.surface(1).length, 0.0);
  EXPECT_EQ(view.points().size(), 3U);
}

TEST(ScanView, SurvivesScansOfFewBeams) {
  EXPECT_FALSE(ScanView().beam_at(0.0));
  EXPECT_FALSE(ScanView(LaserScan()).beam_at(0.0));
  for (const bool closed : {false, true}) {
    for (const std::size_t beams : {1U, 2U}) {
      LaserScan scan = test::scan_of(std::vector<double>(beams, 2.0), -0.1, 0.01);
      scan.closed = closed;
      const ScanView view(scan);
      EXPECT_EQ(view.beam_count(), beams);
      EXPECT_EQ(view.points().size(), 1U);  // 2 cm apart at most
      EXPECT_TRUE(view.points()[0].normal.allFinite());
    }
  }
}

TEST(ScanView, HasNoBeamWithoutAnIncrement) {
  EXPECT_FALSE(ScanView(test::scan_of({2.0}, 0.0, 0.0)).beam_at(0.0));
}

TEST(ScanViewParams, NamesFieldAndValueOfWhatIsWrong) {
  ScanViewParams params;
  params.normal_reach = -0.5;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("normal_reach = -0.5: "), 0U) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
