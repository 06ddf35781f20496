// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "falko_slam/calibration/reflector_motion.hpp"

namespace falko_slam {

/// Covariance of the error of a motion with that of the next one, (x, y, turn) of each, by what
/// both see alike from the halt between them: each reflector displaced by `lasting_noise` [m] in
/// each coordinate, whichever scans of the halt are averaged.
///
/// Displacements d_i of points p_i move a registration by e = N^-1 sum_i w_i J_i^T d_i with
/// N = sum_i w_i J_i^T J_i, J_i = (I, (-p_y, p_x)^T), so what two of them have in common is
///
///     E[e_a e_b^T] = lasting_noise^2 N_a^-1 (sum_(i in both) w_ai w_bi J_i^T J_i) N_b^-1
///
/// in the laser's frame. At its end it goes into a motion s as s e^-1, at its start as e s: errors
/// of opposite sign in the turn, but of one sign in the direction of the chord.
Eigen::Matrix3d covariance_at_halt(const ReflectorMotion& before, const ReflectorMotion& after,
                                   double lasting_noise);

}  // namespace falko_slam
