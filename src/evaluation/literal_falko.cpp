// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/literal_falko.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/line2.hpp"

namespace falko_slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// Eqs. (3.5)-(3.7).
int sector_of(const Eigen::Vector2d& offset, double reference, int sectors) {
  const double angle = std::atan2(offset.y(), offset.x()) - reference;
  const int sector = static_cast<int>(std::floor(sectors / kTwoPi * angle));
  return ((sector % sectors) + sectors) % sectors;
}

// Eqs. (3.8), (3.9): all pairs.
double score_of(const Points& side, const Eigen::Vector2d& center, double reference, int sectors) {
  double sum = 0.0;
  for (std::size_t h = 0; h < side.size(); ++h) {
    for (std::size_t k = h + 1; k < side.size(); ++k) {
      const int d = std::abs(sector_of(side[h] - center, reference, sectors) -
                             sector_of(side[k] - center, reference, sectors));
      sum += std::min(d, sectors - d);
    }
  }
  return sum;
}

Eigen::Vector2d centroid(const Points& side, const Eigen::Vector2d& center) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& point : side) sum += point - center;
  return sum / static_cast<double>(side.size());
}

// Section 3.1.2.
Eigen::Vector2d refine(Points right, Points left, const Eigen::Vector2d& center, double limit) {
  right.push_back(center);
  left.push_back(center);
  const auto right_line = fit_line(right);
  const auto left_line = fit_line(left);
  if (!right_line || !left_line) return center;
  const auto corner = intersection(right_line->line, left_line->line);
  return corner && (*corner - center).norm() < limit ? *corner : center;
}

struct Candidate {
  Keypoint keypoint;
  Eigen::Vector2d point;
};

std::optional<Candidate> examine(const LaserScan& scan, const Points& points, std::size_t i,
                                 const LiteralFalkoParams& params) {
  const Eigen::Vector2d& center = points[i];
  const double radius = params.radius_scale * std::exp(params.radius_growth * scan.ranges[i]);
  Points right;
  Points left;
  for (std::size_t j = 0; j < scan.size(); ++j) {
    if (j == i || !scan.valid(j) || (points[j] - center).norm() > radius) continue;
    (j < i ? right : left).push_back(points[j]);  // (3.1), (3.2)
  }
  if (right.size() < 2 || left.size() < 2) return std::nullopt;

  const Eigen::Vector2d base = left.back() - right.front();  // (3.3), (3.4)
  const Eigen::Vector2d side = center - right.front();
  const double height = std::abs(base.x() * side.y() - base.y() * side.x()) / base.norm();
  const double limit = radius / params.triangle_ratio;
  if (!(base.norm() >= limit) || !(height >= limit)) return std::nullopt;

  Candidate candidate;
  candidate.point = center;
  candidate.keypoint.beam = i;
  candidate.keypoint.radius = radius;
  const double reference = scan.bearing(i);
  candidate.keypoint.score = score_of(right, center, reference, params.sectors) +
                             score_of(left, center, reference, params.sectors);  // (3.10)
  const Eigen::Vector2d axis = centroid(right, center) + centroid(left, center);
  candidate.keypoint.orientation = wrap_angle(std::atan2(axis.y(), axis.x()));
  candidate.keypoint.position = refine(right, left, center, params.refinement_limit);
  return candidate;
}

}  // namespace

std::vector<Keypoint> literal_falko(const LaserScan& scan, const LiteralFalkoParams& params) {
  Points points;
  for (std::size_t i = 0; i < scan.size(); ++i) points.push_back(scan.point(i));
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (!scan.valid(i)) continue;
    if (auto candidate = examine(scan, points, i, params)) candidates.push_back(*candidate);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.keypoint.score < b.keypoint.score;
  });

  std::vector<Candidate> kept;
  for (const auto& candidate : candidates) {
    const bool suppressed = std::any_of(kept.begin(), kept.end(), [&](const auto& better) {
      return (better.point - candidate.point).norm() <= params.suppression_radius;
    });
    if (!suppressed) kept.push_back(candidate);
  }
  std::vector<Keypoint> keypoints;
  keypoints.reserve(kept.size());
  for (const auto& candidate : kept) keypoints.push_back(candidate.keypoint);
  std::sort(keypoints.begin(), keypoints.end(),
            [](const auto& a, const auto& b) { return a.beam < b.beam; });
  return keypoints;
}

}  // namespace falko_slam
