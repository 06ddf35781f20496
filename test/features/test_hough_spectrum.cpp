// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/hough_spectrum.hpp"

#include <gtest/gtest.h>

#include "falko_slam/evaluation/scan_perturbation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"
#include "support/synthetic_scans.hpp"

namespace falko_slam {
namespace {

constexpr double kQuarter = kPi / 2.0;

// Difference of two directions that are the same after any quarter turn.
double difference(double a, double b) {
  const double d = a - b;
  return std::abs(d - kQuarter * std::round(d / kQuarter));
}

Scene rectangle() {
  Scene scene;
  scene.add_box({0.0, 0.0, 0.0}, {6.0, 4.0});
  return scene;
}

TEST(HoughSpectrum, FindsTheWallsOfARoom) {
  auto random = test::seeded_random();
  HoughSpectrum spectrum;
  for (double heading = -3.0; heading < 3.0; heading += 0.17) {
    const auto scan = test::closed_scan(rectangle(), {0.5, 0.3, heading}, 720, 0.01, random);
    const auto direction = spectrum.dominant_direction(scan);
    ASSERT_TRUE(direction);
    EXPECT_GE(*direction, 0.0);
    EXPECT_LT(*direction, kQuarter);
    EXPECT_LT(difference(*direction, -heading), degrees_to_radians(1.0)) << heading;
  }
}

TEST(HoughSpectrum, TurnsWithTheScanBeyondItsCells) {
  auto random = test::seeded_random();
  HoughSpectrum spectrum;
  const auto scan = test::closed_scan(office_scene(), {-3.0, -1.0, 0.4}, 1440, 0.01, random);
  const auto direction = spectrum.dominant_direction(scan);
  ASSERT_TRUE(direction);
  for (const std::size_t by : {1U, 77U, 720U}) {
    const auto turned = spectrum.dominant_direction(with_beams_rotated(scan, by));
    ASSERT_TRUE(turned);
    const double angle = static_cast<double>(by) * scan.angle_increment;
    EXPECT_LT(difference(*turned + angle, *direction), 1e-7) << by;
  }
}

TEST(HoughSpectrum, PeaksAtTheNormalsOfTheWalls) {
  auto random = test::seeded_random();
  HoughSpectrum spectrum;
  spectrum.dominant_direction(test::closed_scan(rectangle(), {}, 720, 0.0, random));
  const auto& energy = spectrum.spectrum();
  ASSERT_EQ(energy.size(), 90U);
  const auto best = std::max_element(energy.begin(), energy.end()) - energy.begin();
  EXPECT_TRUE(best == 0 || best == 45) << best;
}

TEST(HoughSpectrum, HasNoDirectionWithoutWalls) {
  HoughSpectrum spectrum;
  EXPECT_FALSE(spectrum.dominant_direction(LaserScan{}));
  LaserScan scan;
  scan.angle_increment = 0.1;
  scan.ranges = {1.0, std::nan(""), 1.0};
  scan.status = {BeamStatus::kValid, BeamStatus::kZero, BeamStatus::kValid};
  EXPECT_FALSE(spectrum.dominant_direction(scan));
}

TEST(HoughSpectrumParams, AreChecked) {
  HoughSpectrumParams params;
  params.angles = 9;
  EXPECT_THROW(HoughSpectrum spectrum(params), std::invalid_argument);
  params = {};
  params.offset_cell = 0.0;
  EXPECT_THROW(HoughSpectrum spectrum(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
