// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/falko.hpp"

#include <algorithm>
#include <cmath>

#include "corner_block.hpp"
#include "falko_slam/features/sector_grid.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "non_maximum_suppression.hpp"
#include "sampled_scan.hpp"

namespace falko_slam {

struct FalkoDetector::Workspace {
  explicit Workspace(const FalkoParams& params)
      : tests{static_cast<float>(params.triangle_ratio),
              static_cast<float>(std::tan(params.neighborhood.min_incidence)),
              static_cast<float>(params.neighborhood.min_points_per_side),
              static_cast<float>(params.refinement_limit)},
        ranking(params.ranking),
        scan(params.neighborhood),
        sectors(params.sectors),
        histogram(params.sectors) {}

  void find_candidates();
  void add_candidate(const CornerBlock& corners, const BeamBlock& block, std::size_t lane);
  double side_score(std::size_t beam, SampledScan::Side side);
  double sector_score(std::size_t beam);

  CornerTests tests;
  FalkoParams::Ranking ranking;
  SampledScan scan;
  SectorGrid sectors;
  SectorHistogram histogram;
  std::vector<CornerCandidate> candidates;
  NonMaximumSuppression suppression;
};

// Eqs. (3.8) and (3.9): the more the points of a side lie in one direction, the smaller.
double FalkoDetector::Workspace::side_score(std::size_t beam, SampledScan::Side side) {
  histogram.clear();
  scan.for_each(beam, side,
                [&](const Offset& point) { histogram.add(sectors.sector(point.x, point.y)); });
  return static_cast<double>(histogram.pairwise_distance());
}

// Eq. (3.10).
double FalkoDetector::Workspace::sector_score(std::size_t beam) {
  return side_score(beam, SampledScan::Side::kRight) + side_score(beam, SampledScan::Side::kLeft);
}

void FalkoDetector::Workspace::add_candidate(const CornerBlock& corners, const BeamBlock& block,
                                             std::size_t lane) {
  CornerCandidate candidate;
  candidate.beam = block.first + lane;
  candidate.range = *scan.ranges(candidate.beam);
  const Eigen::Vector2d& direction = scan.direction(candidate.beam);
  const double along = candidate.range + corners.x[lane];
  const double across = corners.y[lane];
  candidate.position = {direction.x() * along - direction.y() * across,
                        direction.y() * along + direction.x() * across};
  candidate.axis = {corners.axis_x[lane], corners.axis_y[lane]};
  candidate.slope = corners.slope[lane];
  candidate.roughness_square = corners.roughness_square[lane];
  candidate.rank = ranking == FalkoParams::Ranking::kRoughness
                       ? corners.roughness_square[lane]
                       : static_cast<float>(sector_score(candidate.beam));
  candidates.push_back(candidate);
}

void FalkoDetector::Workspace::find_candidates() {
  candidates.clear();
  CornerBlock corners;
  for (const BeamBlock& block : scan.blocks()) {
    if (!find_corners(scan, block, tests, corners)) continue;
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      if (corners.corner[lane] != 0) add_candidate(corners, block, lane);
    }
  }
}

FalkoDetector::FalkoDetector(const FalkoParams& params) : params_(params) {
  validate(params_);
  workspace_ = std::make_unique<Workspace>(params_);
}
FalkoDetector::~FalkoDetector() = default;
FalkoDetector::FalkoDetector(FalkoDetector&&) noexcept = default;
FalkoDetector& FalkoDetector::operator=(FalkoDetector&&) noexcept = default;

void FalkoDetector::detect(const LaserScan& scan, std::vector<Keypoint>& keypoints) {
  keypoints.clear();
  if (scan.size() < 2 || !(scan.angle_increment > 0.0)) return;
  Workspace& work = *workspace_;
  work.scan.assign(scan);
  work.find_candidates();
  for (const KeptCorner& kept :
       work.suppression(work.candidates, params_.suppression_radius, params_.merge_radius)) {
    const CornerCandidate& corner = work.candidates[kept.index];
    Keypoint keypoint;
    keypoint.position = kept.position;
    keypoint.orientation =
        wrap_angle(std::atan2(corner.axis.y(), corner.axis.x()) + scan.bearing(corner.beam));
    keypoint.radius = std::sqrt(*work.scan.radius_squares(corner.beam));
    keypoint.score = work.sector_score(corner.beam);
    keypoint.roughness = std::sqrt(corner.roughness_square);
    keypoint.beam = corner.beam;
    keypoints.push_back(keypoint);
  }
}

std::vector<Keypoint> FalkoDetector::detect(const LaserScan& scan) {
  std::vector<Keypoint> keypoints;
  detect(scan, keypoints);
  return keypoints;
}

}  // namespace falko_slam
