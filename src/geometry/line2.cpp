// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/line2.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {

std::optional<LineFit> fit_line(const std::vector<Eigen::Vector2d>& points, double point_noise) {
  if (points.size() < 2) return std::nullopt;
  const Eigen::Vector2d& origin = points.front();
  LineMoments moments;
  for (const auto& point : points) moments.add(point.x() - origin.x(), point.y() - origin.y());
  const LineMoments::Fit fit = moments.fit();
  if (!(fit.spread_along > 0.0)) return std::nullopt;

  const double count = moments.weight();
  double squares = 0.0;  // summed from the distances: the moments lose the smallest of them
  for (const auto& point : points) squares += std::pow(fit.line.signed_distance(point - origin), 2);
  LineFit result;
  result.line = {fit.line.normal, fit.line.offset + fit.line.normal.dot(origin)};
  result.rms_distance = std::sqrt(squares / count);
  const double variance = point_noise > 0.0 ? point_noise * point_noise
                          : count > 2.0     ? squares / (count - 2.0)
                                            : 0.0;
  // Angle and offset at the centroid are uncorrelated; moving the offset to the origin couples them
  // by the centroid's coordinate along the line.
  const Eigen::Vector2d centroid = origin + moments.mean();
  const double along = -fit.line.normal.y() * centroid.x() + fit.line.normal.x() * centroid.y();
  const double angle_variance = variance / fit.spread_along;
  result.covariance << angle_variance, along * angle_variance, along * angle_variance,
      variance / count + along * along * angle_variance;
  return result;
}

std::optional<Eigen::Vector2d> intersection(const Line2& a, const Line2& b, double min_angle) {
  const double determinant = a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x();
  if (std::abs(determinant) <= std::sin(min_angle)) return std::nullopt;
  return Eigen::Vector2d((a.offset * b.normal.y() - b.offset * a.normal.y()) / determinant,
                         (a.normal.x() * b.offset - b.normal.x() * a.offset) / determinant);
}

}  // namespace falko_slam
