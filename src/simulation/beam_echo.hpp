// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "falko_slam/simulation/laser_model.hpp"
#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// A beam as a bundle of rays over its width: a Gaussian profile whose radius is where the power
/// has fallen to 1 / e^2, which is what data sheets call the beam's radius.
struct BeamProfile {
  static constexpr std::size_t kRays = 7;
  std::array<double, kRays> offset{};  ///< from the axis, in radii
  std::array<double, kRays> weight{};  ///< share of the power; they sum to 1
};
BeamProfile gaussian_beam();

/// The light that one ray brings back.
struct RayEcho {
  double range = 0.0;  ///< [m]
  double power = 0.0;  ///< of a white surface that faces the whole beam at 1 m: 1
};

/// Light that comes back from a surface, before it is spread over the range: (1 / r^2 is not in
/// it). A retroreflector keeps its gain up to an incidence of 45 degrees and has none beyond 75.
double returned_light(const Surface& surface, double cosine_of_incidence);

/// What the receiver makes of a bundle: surfaces that lie near each other melt into one echo at
/// their mean, weighted by power; of several echoes the strongest counts. A power of 0: there is
/// none. Sorts the bundle.
RayEcho strongest_echo(std::array<RayEcho, BeamProfile::kRays>& bundle, double separation);

/// The weakest power that is seen.
double weakest_power(const LaserModel& laser);

/// What the scanner says of the brightness of an echo: 0 to 65535, whole numbers.
float intensity_of(const LaserModel& laser, double power);

}  // namespace falko_slam
