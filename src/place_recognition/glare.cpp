// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/glare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kSum = 4096.0;
constexpr int kReach = 1;  // cells on either side that a pair is spread over
constexpr int kWidth = 2 * kReach + 1;

using Weights = std::array<std::int64_t, kWidth>;

// Samples of the Gaussian at the centres of the cells around a place in the middle one, in fixed
// point: sums do not depend on the order then. Linear between the steps of a table.
class Spread {
 public:
  explicit Spread(double sigma) {
    for (std::size_t step = 0; step <= kSteps; ++step) {
      const double place = static_cast<double>(step) / kSteps - 0.5;
      for (int i = 0; i < kWidth; ++i) {
        const double distance = (i - kReach - place) / sigma;
        table_[step][static_cast<std::size_t>(i)] = kOne * std::exp(-0.5 * distance * distance);
      }
    }
  }

  // `fraction` of the middle cell, in [0, 1).
  Weights at(double fraction) const {
    const double place = fraction * kSteps;
    const auto step = std::min<std::size_t>(static_cast<std::size_t>(place), kSteps - 1);
    const double rest = place - static_cast<double>(step);
    Weights weights;
    for (std::size_t i = 0; i < kWidth; ++i) {
      weights[i] = std::llround((1.0 - rest) * table_[step][i] + rest * table_[step + 1][i]);
    }
    return weights;
  }

 private:
  static constexpr std::size_t kSteps = 32;
  static constexpr double kOne = 1 << 16;
  std::array<std::array<double, kWidth>, kSteps + 1> table_{};
};

class Accumulator {
 public:
  explicit Accumulator(const GlareParams& params)
      : params_(params),
        spread_(params.spread),
        cells_(static_cast<std::size_t>(params.direction_cells * params.distance_cells)) {}

  void add(Eigen::Vector2d difference) {
    const double distance = difference.norm() / params_.distance_cell_size;
    if (!(distance < params_.distance_cells)) return;
    // From the lower to the upper point, so that their order changes not even the rounding.
    if (difference.y() < 0.0 || (difference.y() == 0.0 && difference.x() < 0.0)) difference *= -1.0;
    const double direction =
        std::atan2(difference.y(), difference.x()) * params_.direction_cells / kPi;
    const auto row = static_cast<int>(direction);
    const auto column = static_cast<int>(distance);
    const Weights along = spread_.at(distance - column);
    const Weights across = spread_.at(direction - row);
    for (int i = 0; i < kWidth; ++i) {
      const int r = (row + i - kReach + params_.direction_cells) % params_.direction_cells;
      for (int j = 0; j < kWidth; ++j) {
        const int c = column + j - kReach;
        if (c < 0 || c >= params_.distance_cells) continue;
        cells_[static_cast<std::size_t>(r * params_.distance_cells + c)] +=
            across[static_cast<std::size_t>(i)] * along[static_cast<std::size_t>(j)];
      }
    }
  }

  Signature scaled() const {
    Signature signature;
    signature.rows = params_.direction_cells;
    signature.columns = params_.distance_cells;
    double sum = 0.0;
    for (const std::int64_t cell : cells_) sum += static_cast<double>(cell);
    const double scale = sum > 0.0 ? kSum / sum : 0.0;
    for (const std::int64_t cell : cells_) {
      const double value = std::round(scale * static_cast<double>(cell));
      signature.cells.push_back(static_cast<std::uint8_t>(std::min(255.0, value)));
    }
    return signature;
  }

 private:
  GlareParams params_;
  Spread spread_;
  std::vector<std::int64_t> cells_;
};

}  // namespace

void validate(const GlareParams& params) {
  require_in_range("direction_cells", params.direction_cells, 2, 64);
  require_in_range("distance_cells", params.distance_cells, 1, 1000);
  require_in_range("distance_cell_size", params.distance_cell_size, 1e-3, 100.0);
  require_in_range("spread", params.spread, 0.2, 2.0);
}

Signature glare(const std::vector<Eigen::Vector2d>& points, const GlareParams& params) {
  validate(params);
  Accumulator accumulator(params);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) accumulator.add(points[i] - points[j]);
  }
  return accumulator.scaled();
}

}  // namespace falko_slam
