// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/calibration/reflector_motion.hpp"

namespace falko_slam {

/// How much too near a scanner reports all of its reflectors: half a beam on a cylinder is not on
/// its axis, and devices differ in what they add.
struct RangeOffset {
  double offset = 0.0;     ///< to be added to each range [m]
  double deviation = 0.0;  ///< its standard deviation [m]
};

/// The offset with which the reflectors of all motions fit best: seen from the other end of an arc,
/// a range that is too short shifts a reflector another way. `prior` is the standard deviation that
/// an offset may have anyway [m]. No motions: 0 with that deviation.
RangeOffset estimate_range_offset(const std::vector<ReflectorMotion>& motions, double prior = 0.02);

/// The same motion from reflectors with mended ranges.
ReflectorMotion with_range_offset(const ReflectorMotion& motion, double offset);

}  // namespace falko_slam
