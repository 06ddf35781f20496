// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "beam_echo.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {

BeamProfile gaussian_beam() {
  constexpr double kEdge = 1.5;  // [radii]; beyond it a hundredth of the axis' power is left
  BeamProfile beam;
  double sum = 0.0;
  for (std::size_t i = 0; i < BeamProfile::kRays; ++i) {
    beam.offset[i] = kEdge * (2.0 * static_cast<double>(i) / (BeamProfile::kRays - 1) - 1.0);
    beam.weight[i] = std::exp(-2.0 * beam.offset[i] * beam.offset[i]);
    sum += beam.weight[i];
  }
  for (double& weight : beam.weight) weight /= sum;
  return beam;
}

double returned_light(const Surface& surface, double cosine_of_incidence) {
  constexpr double kFull = 0.7071067811865476;   // cos 45 degrees
  constexpr double kNone = 0.25881904510252074;  // cos 75 degrees
  const double matt = surface.reflectivity * cosine_of_incidence;
  const double retro = std::clamp((cosine_of_incidence - kNone) / (kFull - kNone), 0.0, 1.0);
  return matt + surface.retro_gain * retro;
}

RayEcho strongest_echo(std::array<RayEcho, BeamProfile::kRays>& bundle, double separation) {
  std::sort(bundle.begin(), bundle.end(),
            [](const RayEcho& a, const RayEcho& b) { return a.range < b.range; });
  RayEcho strongest;
  RayEcho current;
  double last = bundle.front().range;
  const auto close = [&] {
    if (current.power > strongest.power) {
      strongest = {current.range / current.power, current.power};
    }
    current = {};
  };
  for (const RayEcho& ray : bundle) {
    if (ray.power <= 0.0) continue;
    if (ray.range > last + separation) close();
    last = ray.range;
    current.range += ray.power * ray.range;
    current.power += ray.power;
  }
  close();
  return strongest;
}

double weakest_power(const LaserModel& laser) {
  return 0.1 / (laser.range_of_dark * laser.range_of_dark);
}

float intensity_of(const LaserModel& laser, double power) {
  constexpr double kMost = 65535.0;
  const double value = laser.white_intensity * std::pow(power, laser.intensity_exponent);
  return static_cast<float>(std::min(kMost, std::round(value)));
}

}  // namespace falko_slam
