// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/gsr.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "pair_histogram.hpp"

namespace falko_slam {

void validate(const GsrParams& params) {
  require_in_range("angle_cells", params.angle_cells, 2, 64);
  require_in_range("distance_cells", params.distance_cells, 1, 1000);
  require_in_range("distance_cell_size", params.distance_cell_size, 1e-3, 100.0);
  require_in_range("spread", params.spread, 0.2, 2.0);
}

Signature gsr(const std::vector<MatchPoint>& points, const GsrParams& params) {
  validate(params);
  PairHistogram pairs(params.angle_cells, params.distance_cells, params.spread,
                      PairHistogram::Rows::kFolded);
  const double last = std::nextafter(params.angle_cells, 0.0);  // the angle pi belongs to its row
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].has_orientation()) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (!points[j].has_orientation()) continue;
      const double distance = (points[i].position - points[j].position).norm();
      const double angle = std::abs(angle_between(points[i].orientation, points[j].orientation));
      pairs.add(std::min(last, angle * params.angle_cells / kPi),
                distance / params.distance_cell_size);
    }
  }
  return pairs.scaled();
}

}  // namespace falko_slam
