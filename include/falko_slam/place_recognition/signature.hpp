// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace falko_slam {

/// A table over the circle of directions of lines: row t is the directions of cell t out of `rows`
/// over [0, pi), the columns are anything that does not change when the scan turns. Turning the
/// scan by a whole cell shifts the rows around.
///
/// Small integers: a signature of 8 x 50 cells takes 400 bytes, and 16 of them are compared at
/// once.
struct Signature {
  int rows = 0;
  int columns = 0;
  std::vector<std::uint8_t> cells;  ///< row after row

  std::uint8_t at(int row, int column) const {
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(column)];
  }
  /// No cell is set: nothing was seen that a place could be known by.
  bool empty() const;
};

/// Both tables side by side, for comparison with one common shift. Throws std::invalid_argument if
/// they have different numbers of rows.
Signature joined(const Signature& left, const Signature& right);

/// Sum of the absolute differences of the cells: the L1 norm. Throws std::invalid_argument if the
/// shapes differ.
std::uint32_t l1_distance(const Signature& a, const Signature& b);

struct ShiftedDistance {
  std::uint32_t distance = 0;
  int shift = 0;  ///< b turned by `shift` rows comes nearest to a; the smallest one of several
};

/// SL_1 of \cite kallasi2017 (4.2): the smallest L1 distance over all shifts of the rows,
///     min_k sum_t sum_r |a(t, r) - b((t + k) mod rows, r)|.
/// A metric on signatures up to shifts: shifts keep L1, so the triangle inequality carries over.
ShiftedDistance shifted_distance(const Signature& a, const Signature& b);

}  // namespace falko_slam
