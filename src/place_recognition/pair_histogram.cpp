// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "pair_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

constexpr double kSum = 4096.0;
constexpr double kOne = 1 << 16;  // of the fixed point

}  // namespace

// Samples of the Gaussian at the centres of the cells around a place in the middle one.
PairHistogram::PairHistogram(int rows, int columns, double spread, Rows kind)
    : rows_(rows),
      columns_(columns),
      kind_(kind),
      cells_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns)) {
  for (std::size_t step = 0; step <= kSteps; ++step) {
    const double place = static_cast<double>(step) / kSteps - 0.5;
    for (int i = 0; i < kWidth; ++i) {
      const double distance = (i - kReach - place) / spread;
      gaussian_[step][static_cast<std::size_t>(i)] = kOne * std::exp(-0.5 * distance * distance);
    }
  }
}

// `fraction` of the middle cell, in [0, 1); linear between the steps of the table.
PairHistogram::Weights PairHistogram::weights_at(double fraction) const {
  const double place = fraction * kSteps;
  const auto step = std::min<std::size_t>(static_cast<std::size_t>(place), kSteps - 1);
  const double rest = place - static_cast<double>(step);
  Weights weights;
  for (std::size_t i = 0; i < kWidth; ++i) {
    weights[i] = std::llround((1.0 - rest) * gaussian_[step][i] + rest * gaussian_[step + 1][i]);
  }
  return weights;
}

int PairHistogram::neighboring_row(int row) const {
  if (kind_ == Rows::kCircle) return (row + rows_) % rows_;
  return std::clamp(row, 0, rows_ - 1);
}

void PairHistogram::add(double row, double column) {
  if (!(column < columns_)) return;
  const auto middle_row = static_cast<int>(row);
  const auto middle_column = static_cast<int>(column);
  const Weights along = weights_at(column - middle_column);
  const Weights across = weights_at(row - middle_row);
  for (int i = 0; i < kWidth; ++i) {
    const int r = neighboring_row(middle_row + i - kReach);
    for (int j = 0; j < kWidth; ++j) {
      const int c = middle_column + j - kReach;
      if (c < 0 || c >= columns_) continue;
      cells_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
             static_cast<std::size_t>(c)] +=
          across[static_cast<std::size_t>(i)] * along[static_cast<std::size_t>(j)];
    }
  }
}

Signature PairHistogram::scaled() const {
  Signature signature;
  signature.rows = rows_;
  signature.columns = columns_;
  double sum = 0.0;
  for (const std::int64_t cell : cells_) sum += static_cast<double>(cell);
  const double scale = sum > 0.0 ? kSum / sum : 0.0;
  for (const std::int64_t cell : cells_) {
    const double value = std::round(scale * static_cast<double>(cell));
    signature.cells.push_back(static_cast<std::uint8_t>(std::min(255.0, value)));
  }
  return signature;
}

}  // namespace falko_slam
