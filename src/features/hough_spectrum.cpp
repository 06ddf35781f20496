// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/hough_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "beam_directions.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// The direction of a wall is measured over about this length, so that noise of a few centimetres
// turns it by a few degrees only; points farther apart than kMaxLength are not of one wall. [m]
constexpr double kLength = 0.3;
constexpr double kMaxLength = 1.0;
constexpr int kMaxIterations = 50;
constexpr double kConverged = 1e-9;

// Four times an angle as a unit vector (or a sum of such): equal for directions 90 degrees apart.
struct Fourfold {
  double cosine;
  double sine;
};

struct Wall {  // from one point to another
  Fourfold direction;
  double length;
};

Wall wall_along(const Eigen::Vector2d& along, double square) {
  // ((x + i y) / |.|)^4
  const double cosine2 = (along.x() * along.x() - along.y() * along.y()) / square;
  const double sine2 = 2.0 * along.x() * along.y() / square;
  return {{cosine2 * cosine2 - sine2 * sine2, 2.0 * cosine2 * sine2}, std::sqrt(square)};
}

// Mean shift with the weight ((1 + cos 4 d) / 2)^8 for a difference d: half at 6 degrees.
Fourfold settle(const std::vector<Wall>& walls, Fourfold mean) {
  for (int i = 0; i < kMaxIterations; ++i) {
    Fourfold sum{0.0, 0.0};
    for (const Wall& wall : walls) {
      const Fourfold& d = wall.direction;
      const double near = 0.5 + 0.5 * (d.cosine * mean.cosine + d.sine * mean.sine);
      const double near2 = near * near;
      const double near4 = near2 * near2;
      const double weight = wall.length * near4 * near4;
      sum.cosine += weight * d.cosine;
      sum.sine += weight * d.sine;
    }
    const double length = std::hypot(sum.cosine, sum.sine);
    if (!(length > 0.0)) break;
    const Fourfold last = mean;
    mean = {sum.cosine / length, sum.sine / length};
    if (std::abs(mean.cosine - last.cosine) + std::abs(mean.sine - last.sine) < kConverged) break;
  }
  return mean;
}

}  // namespace

struct HoughSpectrum::Workspace {
  void collect(const LaserScan& scan, double max_range);
  struct Energies {
    double a, b;
  };
  Energies energies(std::size_t a, std::size_t b);

  BeamDirections directions;
  std::vector<float> cosine, sine;  // of the cells, over the size of a cell of rho
  std::vector<float> x, y;          // of the points
  std::vector<Wall> walls;
  std::vector<std::int32_t> votes_a, votes_b;  // by rho
};

void HoughSpectrum::Workspace::collect(const LaserScan& scan, double max_range) {
  directions.assign(scan);
  x.clear();
  y.clear();
  walls.clear();
  const std::size_t beams = scan.size();
  const auto point = [&](std::size_t i) -> Eigen::Vector2d {
    return scan.ranges[i] * directions[i];
  };
  for (std::size_t i = 0; i < beams; ++i) {
    if (!(scan.ranges[i] > 0.0 && scan.ranges[i] <= max_range)) continue;
    const Eigen::Vector2d here = point(i);
    x.push_back(static_cast<float>(here.x()));
    y.push_back(static_cast<float>(here.y()));
    const double lag = std::ceil(kLength / (scan.ranges[i] * scan.angle_increment));
    if (!(lag < 0.5 * static_cast<double>(beams))) continue;
    std::size_t other = i + static_cast<std::size_t>(lag);
    if (other >= beams && !scan.closed) continue;
    other %= beams;
    const Eigen::Vector2d along = point(other) - here;
    const double square = along.squaredNorm();
    if (square > 0.0 && square <= kMaxLength * kMaxLength) {
      walls.push_back(wall_along(along, square));
    }
  }
}

// sum over rho of HT(theta, rho)^2 in two directions at once. It is counted while voting: the
// square of n + 1 is 2 n + 1 more than that of n.
HoughSpectrum::Workspace::Energies HoughSpectrum::Workspace::energies(std::size_t a,
                                                                      std::size_t b) {
  std::fill(votes_a.begin(), votes_a.end(), 0);
  std::fill(votes_b.begin(), votes_b.end(), 0);
  const float middle = 0.5F * static_cast<float>(votes_a.size());
  const auto vote = [&](std::vector<std::int32_t>& votes, std::size_t angle, std::size_t point) {
    const float rho = cosine[angle] * x[point] + sine[angle] * y[point] + middle;
    return 2 * votes[static_cast<std::size_t>(static_cast<std::int32_t>(rho))]++ + 1;
  };
  std::int64_t sum_a = 0;
  std::int64_t sum_b = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum_a += vote(votes_a, a, i);
    sum_b += vote(votes_b, b, i);
  }
  return {static_cast<double>(sum_a), static_cast<double>(sum_b)};
}

HoughSpectrum::HoughSpectrum(const HoughSpectrumParams& params)
    : params_(params), workspace_(std::make_unique<Workspace>()) {
  validate(params_);
  for (int i = 0; i < params_.angles; ++i) {
    const double angle = kPi * i / params_.angles;
    workspace_->cosine.push_back(static_cast<float>(std::cos(angle) / params_.offset_cell));
    workspace_->sine.push_back(static_cast<float>(std::sin(angle) / params_.offset_cell));
  }
  const auto cells = static_cast<std::size_t>(params_.max_range / params_.offset_cell);
  workspace_->votes_a.resize(2 * cells + 4);
  workspace_->votes_b.resize(2 * cells + 4);
  spectrum_.resize(workspace_->cosine.size());
}
HoughSpectrum::~HoughSpectrum() = default;
HoughSpectrum::HoughSpectrum(HoughSpectrum&&) noexcept = default;
HoughSpectrum& HoughSpectrum::operator=(HoughSpectrum&&) noexcept = default;

std::optional<double> HoughSpectrum::dominant_direction(const LaserScan& scan) {
  std::fill(spectrum_.begin(), spectrum_.end(), 0.0);
  if (scan.size() < 2) return std::nullopt;
  workspace_->collect(scan, params_.max_range);
  if (workspace_->walls.empty()) return std::nullopt;

  const std::size_t half = spectrum_.size() / 2;
  std::size_t best = 0;
  for (std::size_t i = 0; i < half; ++i) {
    const auto [energy, orthogonal] = workspace_->energies(i, i + half);
    spectrum_[i] = energy;
    spectrum_[i + half] = orthogonal;
    if (energy + orthogonal > spectrum_[best] + spectrum_[best + half]) best = i;
  }
  const double coarse = kPi * static_cast<double>(best) / static_cast<double>(spectrum_.size());
  const Fourfold mean = settle(workspace_->walls, {std::cos(4.0 * coarse), std::sin(4.0 * coarse)});
  const double direction = 0.25 * std::atan2(mean.sine, mean.cosine);
  return direction < 0.0 ? direction + 0.5 * kPi : direction;
}

void validate(const HoughSpectrumParams& params) {
  require_in_range("angles", params.angles, 8, 720);
  if (params.angles % 2 != 0) throw std::invalid_argument("angles: must be even");
  require_in_range("offset_cell", params.offset_cell, 0.001, 10.0);
  require_in_range("max_range", params.max_range, 0.1, 1000.0);
}

}  // namespace falko_slam
