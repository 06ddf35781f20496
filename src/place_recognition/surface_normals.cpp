// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/surface_normals.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "falko_slam/common/validation.hpp"

namespace falko_slam {
namespace {

using Cell = std::pair<long, long>;

// The spread of the points that lie in a cell, about the first of them: no digits are lost.
class Spread {
 public:
  void add(const Eigen::Vector2d& point) {
    if (count_ == 0) origin_ = point;
    const Eigen::Vector2d place = point - origin_;
    ++count_;
    sum_ += place;
    squares_ += place * place.transpose();
  }

  double normal(int min_points) const {
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (count_ < min_points) return none;
    const Eigen::Vector2d mean = sum_ / count_;
    const Eigen::Matrix2d covariance = squares_ / count_ - mean * mean.transpose();
    // Twice the angle of the main axis; the normal is a quarter turn off.
    const double sine = 2.0 * covariance(0, 1);
    const double cosine = covariance(0, 0) - covariance(1, 1);
    if (std::hypot(sine, cosine) <= 1e-9 * covariance.trace()) return none;
    const double axis = 0.5 * std::atan2(sine, cosine);
    Eigen::Vector2d direction(-std::sin(axis), std::cos(axis));
    if (direction.dot(origin_ + mean) > 0.0) direction *= -1.0;
    return std::atan2(direction.y(), direction.x());
  }

 private:
  int count_ = 0;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d sum_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

}  // namespace

void validate(const SurfaceNormalParams& params) {
  require_in_range("cell_size", params.cell_size, 0.01, 100.0);
  require_in_range("min_points", params.min_points, 2, 1000);
}

std::vector<double> surface_normals(const LaserScan& scan,
                                    const std::vector<Eigen::Vector2d>& places,
                                    const SurfaceNormalParams& params) {
  validate(params);
  const auto cell_of = [&](const Eigen::Vector2d& point) {
    return Cell(std::lround(std::floor(point.x() / params.cell_size)),
                std::lround(std::floor(point.y() / params.cell_size)));
  };
  std::map<Cell, Spread> grid;
  for (std::size_t beam = 0; beam < scan.size(); ++beam) {
    if (!scan.valid(beam)) continue;
    const Eigen::Vector2d point = scan.point(beam);
    grid[cell_of(point)].add(point);
  }
  std::vector<double> normals;
  for (const Eigen::Vector2d& place : places) {
    const auto found = grid.find(cell_of(place));
    normals.push_back(found == grid.end() ? std::numeric_limits<double>::quiet_NaN()
                                          : found->second.normal(params.min_points));
  }
  return normals;
}

}  // namespace falko_slam
