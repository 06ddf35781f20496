// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ordinary_intensity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// Surfaces of a tenth of white to white at this range, whose brightness falls with `power` of it.
void add_surfaces(OrdinaryIntensity& intensity, double range, double power) {
  auto random = test::seeded_random();
  for (int i = 0; i < 400; ++i) {
    const double value = 1000.0 * test::uniform(random, 0.1, 1.0) * std::pow(range, power);
    intensity.add(OrdinaryIntensity::cell_of(range, static_cast<float>(value)), 1.0F);
  }
}

TEST(OrdinaryIntensity, KnowsNothingAtFirst) {
  OrdinaryIntensity intensity;
  intensity.settle(0.98F);
  EXPECT_EQ(intensity.at(3.0), 0.0F);
}

TEST(OrdinaryIntensity, IsTheQuantileAtEachRange) {
  OrdinaryIntensity intensity;
  for (const double range : {1.0, 4.0, 16.0}) add_surfaces(intensity, range, -0.8);
  intensity.settle(0.98F);
  for (const double range : {1.0, 4.0, 16.0}) {
    const double white = 1000.0 * std::pow(range, -0.8);
    EXPECT_NEAR(intensity.at(range) / white, 1.0, 0.15) << range;
  }
  intensity.settle(0.5F);
  EXPECT_NEAR(intensity.at(4.0) / (1000.0 * std::pow(4.0, -0.8)), 0.55, 0.1);
}

TEST(OrdinaryIntensity, GoesOnBetweenAndBeyondKnownRanges) {
  OrdinaryIntensity intensity;
  for (const double range : {1.0, 8.0}) add_surfaces(intensity, range, -0.8);
  intensity.settle(0.98F);
  for (const double range : {0.25, 3.0, 30.0}) {
    EXPECT_NEAR(intensity.at(range) / (1000.0 * std::pow(range, -0.8)), 1.0, 0.3) << range;
  }
}

TEST(OrdinaryIntensity, IsNotThatOfReflectingFoil) {
  OrdinaryIntensity intensity;
  add_surfaces(intensity, 2.0, 0.0);
  for (int i = 0; i < 150; ++i) intensity.add(OrdinaryIntensity::cell_of(2.0, 20000.0F), 1.0F);
  intensity.settle(0.98F);
  EXPECT_LT(intensity.at(2.0), 1200.0F);
}

TEST(OrdinaryIntensity, ForgetsAndTakesOut) {
  OrdinaryIntensity intensity;
  add_surfaces(intensity, 2.0, 0.0);
  const auto bright = OrdinaryIntensity::cell_of(2.0, 1900.0F);
  for (int i = 0; i < 100; ++i) intensity.add(bright, 1.0F);
  intensity.settle(0.98F);
  EXPECT_GT(intensity.at(2.0), 1800.0F);
  for (int i = 0; i < 100; ++i) intensity.add(bright, -1.0F);
  intensity.settle(0.98F);
  EXPECT_LT(intensity.at(2.0), 1200.0F);
  intensity.fade(0.0F);
  intensity.settle(0.98F);
  EXPECT_EQ(intensity.at(2.0), 0.0F);
}

TEST(OrdinaryIntensity, TakesAnyNumber) {
  for (const float value : {0.0F, -1.0F, std::nanf(""), INFINITY, 1e-30F, 1e30F}) {
    for (const double range : {0.0, 1e-9, 1e9}) {
      const auto cell = OrdinaryIntensity::cell_of(range, value);
      EXPECT_LT(cell.range, OrdinaryIntensity::kRangeCells);
      EXPECT_LT(cell.intensity, OrdinaryIntensity::kIntensityCells);
    }
  }
}

}  // namespace
}  // namespace falko_slam
