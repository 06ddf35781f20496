// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/features/reflector_detector.hpp"

namespace falko_slam {

/// What a beam sees of a cylinder.
struct FaceInBeam {
  double light = 0.0;  ///< share of its light that comes back
  double depth = 0.0;  ///< mean, weighted by that light, of axis minus face along the beam [m]
};

/// `aside`: of the beam's middle from the cylinder's, across the line of sight; `beam_radius`
/// where it has fallen to 1/e^2; `range`: to the face [m]. Retroreflecting sheets shine back up to
/// an incidence of 45 degrees, less and less up to 75, and not beyond.
FaceInBeam face_in_beam(const ReflectorDetectorParams& params, double aside, double beam_radius,
                        double range);

/// Diameter of a beam at this range [m].
inline double footprint(const ReflectorDetectorParams& params, double range) {
  return params.beam_diameter + params.beam_divergence * range;
}

}  // namespace falko_slam
