// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/wall_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/geometry/line2.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
// No scan is better than this [m]; noise-free ones would weigh infinitely much.
constexpr double kLeastNoise = 1e-4;

}  // namespace

void validate(const WallScanParams& params) {
  require_in_range("max_range", params.max_range, 0.1, 1e5);
  require_in_range("straightness", params.straightness, 0.0, 1.0);
  require_in_range<std::size_t>("end_beams", params.end_beams, 0, 100);
  require_in_range<std::size_t>("min_beams", params.min_beams, 3, 1000);
  require_in_range("piece_length", params.piece_length, 0.01, 100.0);
  require_in_range("part_length", params.part_length, 0.01, 1000.0);
  validate(params.surface);
}

WallScan::WallScan(const LaserScan& scan, double noise, const WallScanParams& params)
    : angle_min_(scan.angle_min), angle_increment_(scan.angle_increment), closed_(scan.closed) {
  if (scan.size() == 0 || !(angle_increment_ > 0.0)) return;
  beams_ = UnrolledScan(scan, params.max_range, params.surface);
  wall_of_.assign(scan.size(), kNone);
  beams_.for_each_surface([&](std::size_t first, std::size_t last) {
    split(first, last, std::max(noise, kLeastNoise), params);
  });
}

void WallScan::split(std::size_t first, std::size_t last, double noise,
                     const WallScanParams& params) {
  constexpr double kBeyondNoise = 4.5;
  if (last + 1 - first < params.min_beams + 2 * params.end_beams) return;
  LineMoments moments;
  for (std::size_t k = first; k <= last; ++k) moments.add(beams_.point(k).x(), beams_.point(k).y());
  const Line2 line = moments.fit().line;
  const Eigen::Vector2d chord = beams_.point(last) - beams_.point(first);
  const Eigen::Vector2d across = Eigen::Vector2d(-chord.y(), chord.x()).stableNormalized();
  double farthest = 0.0, worst = 0.0;
  std::size_t corner = first;
  for (std::size_t k = first; k <= last; ++k) {
    worst = std::max(worst, std::abs(line.signed_distance(beams_.point(k))));
    const double distance = std::abs(across.dot(beams_.point(k) - beams_.point(first)));
    if (distance <= farthest || k == first || k == last) continue;
    farthest = distance;
    corner = k;
  }
  if (worst <= params.straightness + kBeyondNoise * noise) {
    add_wall(first + params.end_beams, last - params.end_beams, params);
  } else if (corner != first) {
    split(first, corner, noise, params);
    split(corner, last, noise, params);
  }
}

void WallScan::add_wall(std::size_t first, std::size_t last, const WallScanParams& params) {
  const auto beams = static_cast<double>(last + 1 - first);
  LineMoments moments;
  for (std::size_t k = first; k <= last; ++k) moments.add(beams_.point(k).x(), beams_.point(k).y());
  const LineMoments::Fit fit = moments.fit();
  StraightWall wall{first, last, fit.line.normal, 0.0, 0.0};
  if (wall.normal.dot(moments.mean()) > 0.0) wall.normal = -wall.normal;
  wall.residual_variance =
      std::max(fit.mean_square_distance * beams / (beams - 2.0), kLeastNoise * kLeastNoise);
  wall.angle_variance = wall.residual_variance / std::max(1e-12, fit.spread_along);
  const std::size_t number = walls_.size();
  walls_.push_back(wall);
  std::fill(wall_of_.begin() + static_cast<std::ptrdiff_t>(first),
            wall_of_.begin() + static_cast<std::ptrdiff_t>(last) + 1, number);
  const double length = (beams_.point(last) - beams_.point(first)).norm();
  constexpr double kLeastBeams = 3.0;
  const double count =
      std::clamp(std::ceil(length / params.piece_length), 1.0, std::floor(beams / kLeastBeams));
  const double pieces_per_part = std::max(1.0, std::round(params.part_length * count / length));
  for (double i = 0.0; i < count; ++i) {
    const auto from = first + static_cast<std::size_t>(std::floor(beams * i / count));
    const auto to = first + static_cast<std::size_t>(std::floor(beams * (i + 1.0) / count)) - 1;
    WallPiece here = piece(number, from, to);
    here.part = parts_ + static_cast<std::size_t>(std::floor(i / pieces_per_part));
    pieces_.push_back(here);
  }
  parts_ = pieces_.back().part + 1;
}

WallPiece WallScan::piece(std::size_t wall, std::size_t first, std::size_t last) const {
  WallPiece found;
  for (std::size_t k = first; k <= last; ++k) found.middle += beams_.point(k);
  const auto beams = static_cast<double>(last + 1 - first);
  found.middle /= beams;
  found.variance = walls_[wall].residual_variance / beams;
  found.first = first;
  found.last = last;
  found.wall = wall;
  return found;
}

std::optional<std::size_t> WallScan::beam_at(double bearing) const {
  if (beams_.size() == 0) return std::nullopt;
  const double turn = kTwoPi / angle_increment_;
  double beam = (bearing - angle_min_) / angle_increment_ + 0.5;
  beam -= turn * std::floor(beam / turn);
  auto nearest = static_cast<std::size_t>(beam);
  if (nearest >= beams_.size()) {
    if (!closed_) return std::nullopt;
    nearest = 0;
  }
  return beams_.place_of(nearest);
}

std::optional<std::size_t> WallScan::wall_at(std::size_t beam) const {
  if (wall_of_[beam] == kNone) return std::nullopt;
  return wall_of_[beam];
}

}  // namespace falko_slam
