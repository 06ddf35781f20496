// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/orthogonal_corner.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "corner_block.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "non_maximum_suppression.hpp"
#include "sampled_scan.hpp"

namespace falko_slam {
namespace {

using Side = SampledScan::Side;

// One coordinate of a side's points along one of the dominant directions.
struct Coordinate {
  double sum = 0.0;
  double squares = 0.0;

  void add(double value) {
    sum += value;
    squares += value * value;
  }
  // With the beam's own point, which is the origin.
  double mean(double points) const { return sum / (points + 1.0); }
  double variance(double points) const {
    return squares / (points + 1.0) - mean(points) * mean(points);
  }
};

// The points of a side in the axes of the dominant directions.
struct SidePoints {
  double count = 0.0;
  Coordinate u, v;
};

SidePoints collect(const SampledScan& scan, std::size_t beam, Side side,
                   const Eigen::Vector2d& axis) {
  SidePoints points;
  scan.for_each(beam, side, [&](const Offset& point) {
    points.u.add(axis.x() * point.x + axis.y() * point.y);
    points.v.add(axis.x() * point.y - axis.y() * point.x);
    points.count += 1.0;
  });
  return points;
}

// A corner with one leg along u and the other along v.
struct Corner {
  Eigen::Vector2d position;  // (u, v)
  Eigen::Vector2d bisector;
  double roughness_square;
};

std::optional<Corner> corner_of(const SidePoints& along_u, const SidePoints& along_v,
                                double min_leg) {
  // A leg reaches from the corner to about twice its mean.
  const double leg_u = 2.0 * along_u.u.sum / along_u.count;
  const double leg_v = 2.0 * along_v.v.sum / along_v.count;
  if (std::abs(leg_u) < min_leg || std::abs(leg_v) < min_leg) return std::nullopt;
  const double squares = leg_u * leg_u + leg_v * leg_v;
  const double height_square = leg_u * leg_u * leg_v * leg_v / squares;
  const double residual = along_u.v.variance(along_u.count) + along_v.u.variance(along_v.count);
  return Corner{{along_v.u.mean(along_v.count), along_u.v.mean(along_u.count)},
                {leg_u > 0.0 ? 1.0 : -1.0, leg_v > 0.0 ? 1.0 : -1.0},
                std::max(0.0, residual) / height_square};
}

// v = (x, y) given along `axis` and across it.
Eigen::Vector2d turn(const Eigen::Vector2d& axis, const Eigen::Vector2d& v) {
  return {axis.x() * v.x() - axis.y() * v.y(), axis.y() * v.x() + axis.x() * v.y()};
}

}  // namespace

struct OrthogonalCornerDetector::Workspace {
  explicit Workspace(const OrthogonalCornerParams& params)
      : tests{static_cast<float>(2.0 * params.leg_ratio),
              static_cast<float>(std::tan(params.neighborhood.min_incidence)),
              static_cast<float>(params.neighborhood.min_points_per_side),
              static_cast<float>(params.refinement_limit)},
        spectrum(params.spectrum),
        scan(params.neighborhood) {}

  void examine(std::size_t beam, const Eigen::Vector2d& dominant,
               const OrthogonalCornerParams& params);

  CornerTests tests;  // only to leave out the beams on straight walls
  HoughSpectrum spectrum;
  SampledScan scan;
  std::vector<CornerCandidate> candidates;
  NonMaximumSuppression suppression;
};

void OrthogonalCornerDetector::Workspace::examine(std::size_t beam, const Eigen::Vector2d& dominant,
                                                  const OrthogonalCornerParams& params) {
  const double range = *scan.ranges(beam);
  const Eigen::Vector2d& direction = scan.direction(beam);
  // The first dominant direction, seen in the frame of the beam.
  const Eigen::Vector2d axis(direction.dot(dominant),
                             direction.x() * dominant.y() - direction.y() * dominant.x());
  const SidePoints right = collect(scan, beam, Side::kRight, axis);
  const SidePoints left = collect(scan, beam, Side::kLeft, axis);
  const double min_leg =
      std::sqrt(static_cast<double>(*scan.radius_squares(beam))) / params.leg_ratio;
  std::optional<Corner> corner = corner_of(left, right, min_leg);
  const std::optional<Corner> other = corner_of(right, left, min_leg);
  if (!corner || (other && other->roughness_square < corner->roughness_square)) corner = other;
  if (!corner || corner->roughness_square > params.max_roughness * params.max_roughness) return;

  Eigen::Vector2d refined = turn(axis, corner->position);
  if (!(refined.norm() < params.refinement_limit)) refined.setZero();
  CornerCandidate candidate;
  candidate.beam = beam;
  candidate.range = range;
  candidate.position = turn(direction, Eigen::Vector2d(range + refined.x(), refined.y()));
  candidate.axis = turn(axis, corner->bisector);
  candidate.slope = candidate.axis.y();
  candidate.roughness_square = corner->roughness_square;
  candidate.rank = static_cast<float>(corner->roughness_square);
  candidates.push_back(candidate);
}

OrthogonalCornerDetector::OrthogonalCornerDetector(const OrthogonalCornerParams& params)
    : params_(params) {
  validate(params_);
  workspace_ = std::make_unique<Workspace>(params_);
}
OrthogonalCornerDetector::~OrthogonalCornerDetector() = default;
OrthogonalCornerDetector::OrthogonalCornerDetector(OrthogonalCornerDetector&&) noexcept = default;
OrthogonalCornerDetector& OrthogonalCornerDetector::operator=(OrthogonalCornerDetector&&) noexcept =
    default;

void OrthogonalCornerDetector::detect(const LaserScan& scan, std::vector<Keypoint>& keypoints) {
  keypoints.clear();
  if (scan.size() < 2 || !(scan.angle_increment > 0.0)) return;
  Workspace& work = *workspace_;
  const std::optional<double> dominant = work.spectrum.dominant_direction(scan);
  if (!dominant) return;
  work.scan.assign(scan);
  work.candidates.clear();
  const Eigen::Vector2d axis(std::cos(*dominant), std::sin(*dominant));
  CornerBlock corners;
  for (const BeamBlock& block : work.scan.blocks()) {
    if (!find_corners(work.scan, block, work.tests, corners)) continue;
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      if (corners.corner[lane] != 0) work.examine(block.first + lane, axis, params_);
    }
  }
  for (const KeptCorner& kept :
       work.suppression(work.candidates, params_.suppression_radius, params_.merge_radius)) {
    const CornerCandidate& corner = work.candidates[kept.index];
    Keypoint keypoint;
    keypoint.position = kept.position;
    keypoint.orientation =
        wrap_angle(std::atan2(corner.axis.y(), corner.axis.x()) + scan.bearing(corner.beam));
    keypoint.radius = std::sqrt(*work.scan.radius_squares(corner.beam));
    keypoint.score = corner.roughness_square;
    keypoint.roughness = std::sqrt(corner.roughness_square);
    keypoint.beam = corner.beam;
    keypoints.push_back(keypoint);
  }
}

std::vector<Keypoint> OrthogonalCornerDetector::detect(const LaserScan& scan) {
  std::vector<Keypoint> keypoints;
  detect(scan, keypoints);
  return keypoints;
}

void validate(const OrthogonalCornerParams& params) {
  validate(params.neighborhood);
  validate(params.spectrum);
  require_in_range("leg_ratio", params.leg_ratio, 1.0, 100.0);
  require_in_range("max_roughness", params.max_roughness, 0.01, 10.0);
  require_in_range("suppression_radius", params.suppression_radius, 0.0, 10.0);
  require_in_range("refinement_limit", params.refinement_limit, 0.0, 10.0);
  require_in_range("merge_radius", params.merge_radius, 0.0, 0.5 * params.suppression_radius);
}

}  // namespace falko_slam
