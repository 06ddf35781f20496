// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/glare.hpp"

#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "pair_histogram.hpp"

namespace falko_slam {

void validate(const GlareParams& params) {
  require_in_range("direction_cells", params.direction_cells, 2, 64);
  require_in_range("distance_cells", params.distance_cells, 1, 1000);
  require_in_range("distance_cell_size", params.distance_cell_size, 1e-3, 100.0);
  require_in_range("spread", params.spread, 0.2, 2.0);
}

Signature glare(const std::vector<Eigen::Vector2d>& points, const GlareParams& params) {
  validate(params);
  PairHistogram pairs(params.direction_cells, params.distance_cells, params.spread,
                      PairHistogram::Rows::kCircle);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Eigen::Vector2d difference = points[i] - points[j];
      const double distance = difference.norm() / params.distance_cell_size;
      if (!(distance < params.distance_cells)) continue;
      // From the lower to the upper point, so that their order changes not even the rounding.
      if (difference.y() < 0.0 || (difference.y() == 0.0 && difference.x() < 0.0)) {
        difference *= -1.0;
      }
      const double direction = std::atan2(difference.y(), difference.x());
      pairs.add(direction * params.direction_cells / kPi, distance);
    }
  }
  return pairs.scaled();
}

}  // namespace falko_slam
