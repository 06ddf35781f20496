// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sampled_scan.hpp"
#include "simd_lanes.hpp"

namespace falko_slam {

struct CornerTests {
  float triangle_ratio;  ///< beta
  float min_incidence_tangent;
  float min_points_per_side;
  float refinement_limit;  ///< [m]
};

/// The corners of one block of beams, each in the frame of its own beam (Offset).
struct CornerBlock {
  IntLanes corner;              ///< mask: the beam passed the tests
  FloatLanes x, y;              ///< where the lines through the two sides meet [m]
  FloatLanes axis_x, axis_y;    ///< sum of unit vectors along the two sides: into the corner
  FloatLanes slope;             ///< how the two sides lean; changes sign in a mirror
  FloatLanes roughness_square;  ///< mean squared residual of the sides over the squared height
};

/// Triangle test, side fits and sub-beam corner of \cite kallasi2017 3.1.1 and 3.1.2 for all beams
/// of the block at once. False if none of them is a corner; `result` is unspecified then.
bool find_corners(const SampledScan& scan, const BeamBlock& block, const CornerTests& tests,
                  CornerBlock& result);

}  // namespace falko_slam
