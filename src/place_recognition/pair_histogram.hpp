// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "falko_slam/place_recognition/signature.hpp"

namespace falko_slam {

/// What pairs of points are counted in: an angle over the rows, their distance over the columns. A
/// pair is spread by a Gaussian over the 3 x 3 cells around it. Sums are in fixed point: they do
/// not depend on the order of the pairs.
class PairHistogram {
 public:
  /// How the rows go on beyond the first and the last.
  enum class Rows {
    kCircle,  ///< the last is beside the first
    kFolded,  ///< each is its own neighbour: angles without a sign
  };

  /// Standard deviation of the Gaussian in cells.
  PairHistogram(int rows, int columns, double spread, Rows kind);

  /// `row` and `column` in cells, whole numbers at the borders. Beyond the last column: left out.
  void add(double row, double column);

  /// Scaled to a sum of 4096, less what exceeds 255 in a cell.
  Signature scaled() const;

 private:
  static constexpr int kReach = 1;  // cells on either side that a pair is spread over
  static constexpr int kWidth = 2 * kReach + 1;
  static constexpr std::size_t kSteps = 32;
  using Weights = std::array<std::int64_t, kWidth>;

  Weights weights_at(double fraction) const;
  int neighboring_row(int row) const;

  int rows_;
  int columns_;
  Rows kind_;
  std::array<std::array<double, kWidth>, kSteps + 1> gaussian_{};
  std::vector<std::int64_t> cells_;
};

}  // namespace falko_slam
