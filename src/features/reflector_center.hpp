// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "bright_run.hpp"
#include "falko_slam/features/reflector_detector.hpp"

namespace falko_slam {

/// Which sides of a reflector something nearer, or the end of the scan, cuts off.
struct HiddenSides {
  bool first = false;
  bool last = false;
};

/// Where the middle of a reflector is seen.
struct ReflectorCenter {
  double beam = 0.0;    ///< counted from the first beam of the run
  double range = 0.0;   ///< to the axis, or to the face of a flat one [m]
  double along = 0.0;   ///< standard deviation along the line of sight [m]
  double across = 0.0;  ///< and across it [m]
  bool hidden = false;  ///< in part: narrower than a whole one beside what could hide it
};

/// From the beams of one reflector; `increment`: from beam to beam [rad].
ReflectorCenter center_of(const ReflectorDetectorParams& params, const BrightBeam* first,
                          std::size_t count, const BrightProfile& profile, HiddenSides hidden,
                          double increment);

}  // namespace falko_slam
