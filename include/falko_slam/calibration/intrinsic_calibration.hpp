// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/vehicle/tricycle.hpp"

namespace falko_slam {

/// Driving scale and steer offset from the angles alone, for a known wheelbase [m]:
///
///     min_psi |A psi - b|^2,   psi = s_w / L (cos alpha_off, sin alpha_off)
///
/// \cite kallasi2017, (2.10) to (2.15), with one offset for both directions. All segments count
/// alike. Empty where M = A^T A is singular to rounding, or nothing turns.
std::optional<TricycleParams> calibrate_standard(const std::vector<PathSegment>& segments,
                                                 double wheelbase);

/// The same with an offset for each direction and one driving scale,
///
///     min_psi |A psi - b|^2   where   |psi_F| = |psi_B|
///
/// (2.16) to (2.27): a search for the Lagrange multiplier on the one interval (A, B) on which it
/// has one root. Empty where M is singular in either direction.
///
/// Deviation: the linear term is c = -S_c V^T P with s_i = +1 where (V^T P)_i >= 0 and psi = V S_c
/// xi, for V in the place of V^T diagonalises nothing and the printed signs return alpha + pi;
/// alpha_B is atan2(psi_4, psi_3) in (2.26). The test against brute force shows both.
std::optional<TricycleParams> calibrate_asymmetric(const std::vector<PathSegment>& segments,
                                                   double wheelbase);

}  // namespace falko_slam
