// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/matching/match_result.hpp"
#include "falko_slam/place_recognition/signature.hpp"

namespace falko_slam {

struct GsrParams {
  /// Cells over the angles [0, pi] between two normals. [2, 64]
  int angle_cells = 8;
  /// n_rho and their size: pairs of points farther apart are left out. [1, 1000], [m]
  int distance_cells = 50;
  double distance_cell_size = 0.20;
  /// Standard deviation of the Gaussian that spreads a pair over the 3 x 3 cells around it [cells].
  /// [0.2, 2]
  double spread = 0.5;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const GsrParams& params);

/// GSR, geometric surface relations (\cite himstedt2015gsr, as \cite kallasi2017 4.1.1 tells of
/// it): how often two points lie how far from each other (rho_ij, (4.1)) with which angle between
/// the normals of their surfaces (theta*_ij). Rows are angles, columns distances; compared by
/// l1_distance(). Neither changes when the points turn or move.
///
/// `MatchPoint::orientation` is the normal. The text leaves open how the difference of two normals
/// is told where the points have no order; here it is the angle between them, without a sign, in
/// [0, pi]. Table and spread are those of GLARE (doc/decisions/0010-gsr-and-phrases.md).
///
/// Scaled to the same sum for any number of points, does not depend on their order. Points without
/// a normal are left out. Fewer than two others, or none near each other: empty.
Signature gsr(const std::vector<MatchPoint>& points, const GsrParams& params = {});

}  // namespace falko_slam
