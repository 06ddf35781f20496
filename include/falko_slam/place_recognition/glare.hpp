// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "falko_slam/place_recognition/signature.hpp"

namespace falko_slam {

struct GlareParams {
  /// n_theta: cells over the directions [0, pi) of the lines through two points. [2, 64]
  int direction_cells = 8;
  /// n_rho and their size: pairs of points farther apart are left out. [1, 1000], [m]
  int distance_cells = 50;
  double distance_cell_size = 0.20;
  /// Standard deviation of the Gaussian that spreads a pair over the 3 x 3 cells around it [cells].
  /// [0.2, 2]
  double spread = 0.5;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const GlareParams& params);

/// GLARE, geometric landmark relations: how often two points lie in which direction and how far
/// from each other (\cite kallasi2017 (4.1)). Rows are directions, columns distances; compared by
/// shifted_distance() it is GLAROT, which knows a place whatever the heading.
///
/// Scaled to the same sum for any number of points (4096, less what exceeds 255 in a cell). Does
/// not depend on the order of the points. Fewer than two points, or none near each other: empty.
/// Cost grows with the square of the number of points. Coordinates must be finite.
Signature glare(const std::vector<Eigen::Vector2d>& points, const GlareParams& params = {});

}  // namespace falko_slam
