// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "reflector_center.hpp"

#include <algorithm>
#include <cmath>

#include "reflector_face.hpp"

namespace falko_slam {
namespace {

double square(double value) { return value * value; }

// Of the mean of a profile that is sampled at beams, in their spacing: found from 2 to 30 m
// (doc/decisions/0019-reflectors.md). A single beam may be anywhere between its neighbours.
constexpr double kSampling = 0.065;
constexpr double kOneBeam = 0.29;

// What a whole reflector is wide at half its peak: light falls off towards the edges of a cylinder,
// beams smear it, receivers compress it. [m]
double whole_width(double diameter, double footprint) {
  return std::hypot(0.9 * diameter, 0.8 * footprint);
}
double width_deviation(double diameter, double footprint) {
  return std::hypot(0.1 * diameter, 0.3 * footprint);
}

// Across the line of sight: beam and standard deviation.
void place_across(const ReflectorDetectorParams& params, std::size_t count,
                  const BrightProfile& profile, HiddenSides hidden, double increment,
                  ReflectorCenter& center) {
  const double spacing = profile.range * increment;
  const double beam_width = footprint(params, profile.range);
  const double jitter = profile.range * params.bearing_noise;
  const double whole = whole_width(params.diameter, beam_width);
  const double seen = spacing * profile.half_width();
  center.hidden = (hidden.first || hidden.last) && seen < whole;
  center.beam = profile.middle;
  if (!center.hidden) {
    // Both edges tell where the middle is.
    center.across = count > 1 ? std::hypot(std::sqrt(0.5) * jitter, kSampling * spacing)
                              : std::hypot(jitter, kOneBeam * spacing);
    return;
  }
  const double deviation = 0.5 * width_deviation(params.diameter, beam_width);
  if (hidden.first && hidden.last) {
    center.across = std::hypot(std::hypot(jitter, deviation), 0.5 * (whole - seen));
    return;
  }
  const double offset = 0.5 * whole / spacing;
  center.beam = hidden.last ? profile.half_begin + offset : profile.half_end - offset;
  center.across = std::hypot(std::hypot(jitter, deviation), 0.15 * spacing);
}

// Along it: the mean of range and depth of the face, weighted by the light that comes back.
void place_along(const ReflectorDetectorParams& params, const BrightBeam* first, std::size_t count,
                 const BrightProfile& profile, double increment, ReflectorCenter& center) {
  if (params.shape == ReflectorDetectorParams::Shape::kFlat) {
    // A strip may stand aslant: what is wrong across is wrong along as well.
    center.range = profile.range;
    center.along = std::hypot(std::hypot(params.range_noise, params.range_bias), center.across);
    return;
  }
  const double radius = 0.5 * footprint(params, profile.range);
  double light = 0.0, squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isnan(first[i].range)) continue;
    const double aside =
        profile.range * std::sin((static_cast<double>(i) - center.beam) * increment);
    const FaceInBeam face = face_in_beam(params, aside, radius, profile.range);
    light += face.light;
    squares += square(face.light);
    sum += face.light * (first[i].range + face.depth);
  }
  if (light > 0.0) {
    center.range = sum / light;
    center.along = std::hypot(params.range_noise * std::sqrt(squares) / light, params.range_bias);
  } else {
    center.range = profile.range + face_in_beam(params, 0.0, radius, profile.range).depth;
    center.along = std::hypot(params.range_noise, 0.5 * params.diameter);
  }
}

}  // namespace

ReflectorCenter center_of(const ReflectorDetectorParams& params, const BrightBeam* first,
                          std::size_t count, const BrightProfile& profile, HiddenSides hidden,
                          double increment) {
  ReflectorCenter center;
  place_across(params, count, profile, hidden, increment, center);
  place_along(params, first, count, profile, increment, center);
  return center;
}

}  // namespace falko_slam
