// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "beam_echo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

using Bundle = std::array<RayEcho, BeamProfile::kRays>;

Bundle near_and_far(double near, double near_power, double far, double far_power) {
  Bundle bundle;
  for (std::size_t i = 0; i < bundle.size(); ++i) {
    bundle[i] = i % 2 == 0 ? RayEcho{far, far_power} : RayEcho{near, near_power};
  }
  return bundle;
}

TEST(BeamEcho, ProfileIsEvenAndWhole) {
  const BeamProfile beam = gaussian_beam();

  EXPECT_NEAR(std::accumulate(beam.weight.begin(), beam.weight.end(), 0.0), 1.0, 1e-12);
  for (std::size_t i = 0; i < BeamProfile::kRays; ++i) {
    const std::size_t mirrored = BeamProfile::kRays - 1 - i;
    EXPECT_NEAR(beam.offset[i], -beam.offset[mirrored], 1e-12);
    EXPECT_NEAR(beam.weight[i], beam.weight[mirrored], 1e-12);
  }
}

TEST(BeamEcho, SurfacesNearEachOtherMixByPower) {
  Bundle bundle = near_and_far(5.0, 3.0, 5.2, 1.0);  // three near rays, four far ones

  const RayEcho echo = strongest_echo(bundle, 0.3);

  EXPECT_NEAR(echo.power, 13.0, 1e-12);
  EXPECT_NEAR(echo.range, (9.0 * 5.0 + 4.0 * 5.2) / 13.0, 1e-12);
}

TEST(BeamEcho, OfSurfacesApartTheBrighterOneCounts) {
  Bundle near_brighter = near_and_far(5.0, 3.0, 6.0, 1.0);
  Bundle far_brighter = near_and_far(5.0, 1.0, 6.0, 3.0);

  EXPECT_NEAR(strongest_echo(near_brighter, 0.3).range, 5.0, 1e-12);
  EXPECT_NEAR(strongest_echo(far_brighter, 0.3).range, 6.0, 1e-12);
}

TEST(BeamEcho, NothingGivesNothing) {
  Bundle bundle;
  bundle.fill({std::numeric_limits<double>::infinity(), 0.0});

  EXPECT_EQ(strongest_echo(bundle, 0.3).power, 0.0);
}

TEST(BeamEcho, MattFadesWithIncidenceAndReflectorsDoNotUntilFarToTheSide) {
  const Surface matt{"matt", 0.6, 0.0};
  const Surface reflector{"reflector", 0.0, 300.0};
  const auto at = [](double degrees) { return std::cos(degrees_to_radians(degrees)); };

  EXPECT_NEAR(returned_light(matt, 1.0), 0.6, 1e-12);
  EXPECT_NEAR(returned_light(matt, at(60.0)), 0.3, 1e-12);
  EXPECT_NEAR(returned_light(reflector, at(0.0)), 300.0, 1e-9);
  EXPECT_NEAR(returned_light(reflector, at(44.9)), 300.0, 1e-9);
  EXPECT_LT(returned_light(reflector, at(60.0)), 250.0);
  EXPECT_EQ(returned_light(reflector, at(76.0)), 0.0);
}

TEST(BeamEcho, IntensitiesAreWholeAndFitSixteenBits) {
  LaserModel laser;
  laser.white_intensity = 4000.0;
  laser.intensity_exponent = 0.5;

  EXPECT_EQ(intensity_of(laser, 1.0), 4000.0F);
  EXPECT_EQ(intensity_of(laser, 0.01), 400.0F);
  EXPECT_EQ(intensity_of(laser, 0.3), std::round(4000.0F * std::sqrt(0.3F)));
  EXPECT_EQ(intensity_of(laser, 1e9), 65535.0F);
}

TEST(BeamEcho, ATenthOfWhiteIsTheWeakestAtItsRange) {
  LaserModel laser;
  laser.range_of_dark = 20.0;

  EXPECT_NEAR(weakest_power(laser), 0.1 / 400.0, 1e-15);
}

}  // namespace
}  // namespace falko_slam
