// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/validation.hpp"
#include "falko_slam/features/falko.hpp"

namespace falko_slam {

void validate(const NeighborhoodParams& params) {
  require_in_range("radius_scale", params.radius_scale, 0.01, 10.0);
  require_in_range("radius_growth", params.radius_growth, 0.0, 1.0);
  require_in_range("max_radius", params.max_radius, params.radius_scale, 100.0);
  require_in_range("sample_spacing", params.sample_spacing, 0.0, 0.5);
  require_in_range("smoothing_window", params.smoothing_window, 0.0, 1.0);
  require_in_range("min_incidence", params.min_incidence, 0.0, 1.0);
  require_in_range("min_points_per_side", params.min_points_per_side, 2, 100);
}

void validate(const FalkoParams& params) {
  validate(params.neighborhood);
  require_in_range("triangle_ratio", params.triangle_ratio, 1.0, 100.0);
  require_in_range("sectors", params.sectors, 4, 1024);
  require_in_range("suppression_radius", params.suppression_radius, 0.0, 10.0);
  require_in_range("refinement_limit", params.refinement_limit, 0.0, 10.0);
  require_in_range("merge_radius", params.merge_radius, 0.0, 0.5 * params.suppression_radius);
}

FalkoParams thesis_falko_params() {
  FalkoParams params;
  params.neighborhood.sample_spacing = 0.0;
  params.neighborhood.smoothing_window = 0.0;
  params.neighborhood.min_incidence = 0.0;
  params.merge_radius = 0.0;
  params.ranking = FalkoParams::Ranking::kSectorScore;
  return params;
}

}  // namespace falko_slam
