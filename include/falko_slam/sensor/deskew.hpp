// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/sensor/surface_step.hpp"

namespace falko_slam {

/// How a laser moves while it scans: with constant velocity and turn, as far as `begin_T_end` in
/// this time.
struct LaserMotion {
  Pose2 begin_T_end;
  Duration duration{};
};

/// The scan that the laser would have taken at one instant, all beams at once, from where it was
/// then; `first_beam_time` is the instant. A scan that takes no time, or a motion that is none,
/// leaves it as it is, bit by bit.
///
/// Each point moves to where it is seen from there (\cite sola2018micro: exp of the twist times the
/// time of its beam); then each beam gets the range of the surface between two neighbouring points,
/// or of a point alone within half a beam, and the nearest one where the moved scan folds over
/// itself. Beams without a return turn along. Directions into which no beam looked, such as those
/// that open at the seam of a scan that turns against its mirror, are kErroneous: nothing is known.
/// O(beams).
LaserScan deskew(const LaserScan& scan, const LaserMotion& motion, Time instant,
                 const SurfaceStepParams& surface = {});

}  // namespace falko_slam
