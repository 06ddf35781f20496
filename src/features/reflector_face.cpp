// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "reflector_face.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace falko_slam {
namespace {

struct FaceRay {
  double aside;   // [beam radii]
  double weight;  // exp(-2 aside^2)
};
constexpr std::array<FaceRay, 9> kRays = {{{-1.5, 0.0111},
                                           {-1.125, 0.0796},
                                           {-0.75, 0.3247},
                                           {-0.375, 0.7548},
                                           {0.0, 1.0},
                                           {0.375, 0.7548},
                                           {0.75, 0.3247},
                                           {1.125, 0.0796},
                                           {1.5, 0.0111}}};
constexpr double kAllLight = 3.3404;

constexpr double kFull = 0.70710678;  // cos 45 degrees
constexpr double kNone = 0.25881905;  // cos 75 degrees

}  // namespace

FaceInBeam face_in_beam(const ReflectorDetectorParams& params, double aside, double beam_radius,
                        double range) {
  const double radius = 0.5 * params.diameter;
  FaceInBeam seen;
  for (const FaceRay& ray : kRays) {
    const double place = (aside + ray.aside * beam_radius) / radius;
    if (std::abs(place) >= 1.0) continue;
    const double cosine = std::sqrt(1.0 - place * place);
    const double light = ray.weight * std::clamp((cosine - kNone) / (kFull - kNone), 0.0, 1.0);
    // Rays aside of the line of sight are longer than what they cover along it.
    const double longer = 0.5 * radius * radius * place * place / range;
    seen.light += light;
    seen.depth += light * (radius * cosine - longer);
  }
  if (seen.light > 0.0) seen.depth /= seen.light;
  seen.light /= kAllLight;
  return seen;
}

}  // namespace falko_slam
