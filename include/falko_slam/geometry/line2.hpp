// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace falko_slam {

/// The line {p : normal . p = offset} with a unit normal; offset in metres.
struct Line2 {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset = 0.0;

  double signed_distance(const Eigen::Vector2d& point) const { return normal.dot(point) - offset; }
};

/// Weighted sums from which the total-least-squares line of a point set follows.
///
/// The sums are relative to the origin of the coordinates: keep the points near it, or precision
/// is lost to cancellation.
class LineMoments {
 public:
  void add(double x, double y, double weight = 1.0) {
    weight_ += weight;
    x_ += weight * x;
    y_ += weight * y;
    xx_ += weight * x * x;
    xy_ += weight * x * y;
    yy_ += weight * y * y;
  }

  double weight() const { return weight_; }
  Eigen::Vector2d mean() const { return {x_ / weight_, y_ / weight_}; }

  struct Fit {
    Line2 line;
    double mean_square_distance;  ///< weighted mean of the squared distances to the line [m^2]
    double spread_along;          ///< weighted sum of squares along the line, about the mean [m^2]
  };
  /// Needs a positive weight. Of points that all coincide any line through them is returned.
  Fit fit() const;

 private:
  double weight_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
};

inline LineMoments::Fit LineMoments::fit() const {
  const double inverse_weight = 1.0 / weight_;
  const double mean_x = x_ * inverse_weight;
  const double mean_y = y_ * inverse_weight;
  const double sxx = xx_ - mean_x * x_;
  const double sxy = xy_ - mean_x * y_;
  const double syy = yy_ - mean_y * y_;

  // The normal is the eigenvector of the smaller eigenvalue of the scatter matrix.
  const double half_difference = 0.5 * (sxx - syy);
  const double radius = std::sqrt(half_difference * half_difference + sxy * sxy);
  const double larger = radius + std::abs(half_difference);
  const double length = std::sqrt(2.0 * radius * larger);
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  if (length > 0.0) {
    normal = half_difference > 0.0 ? Eigen::Vector2d(-sxy / length, larger / length)
                                   : Eigen::Vector2d(larger / length, -sxy / length);
  }
  const double smaller = std::max(0.0, 0.5 * (sxx + syy) - radius);
  return {{normal, normal.x() * mean_x + normal.y() * mean_y},
          smaller * inverse_weight,
          smaller + 2.0 * radius};
}

/// A line with the covariance of (direction of the normal [rad], offset [m]).
struct LineFit {
  Line2 line;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double rms_distance = 0.0;  ///< [m]
};

/// Total-least-squares line (orthogonal regression).
///
/// The covariance follows from isotropic point noise: of standard deviation `point_noise` [m] where
/// that is positive, else estimated from the residuals (n - 2 degrees of freedom).
/// Empty for fewer than two distinct points.
std::optional<LineFit> fit_line(const std::vector<Eigen::Vector2d>& points,
                                double point_noise = 0.0);

/// Empty for lines that are parallel to within `min_angle` [rad].
std::optional<Eigen::Vector2d> intersection(const Line2& a, const Line2& b,
                                            double min_angle = 1e-9);

}  // namespace falko_slam
