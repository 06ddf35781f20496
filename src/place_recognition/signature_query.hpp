// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "falko_slam/place_recognition/signature.hpp"

namespace falko_slam {

/// A loop that compilers turn into one instruction for 16 cells (psadbw).
inline std::uint32_t l1_distance(const std::uint8_t* a, const std::uint8_t* b, std::size_t size) {
  int sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += std::abs(static_cast<int>(a[i]) - b[i]);
  return static_cast<std::uint32_t>(sum);
}

/// The same for sums of cells.
inline std::uint32_t l1_distance(const std::uint16_t* a, const std::uint16_t* b, std::size_t size) {
  int sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += std::abs(static_cast<int>(a[i]) - b[i]);
  return static_cast<std::uint32_t>(sum);
}

/// Sums of each row; they turn with the scan. Their L1 distance is a lower bound for each shift.
/// All sums are at most 65535, or stand for one that is not smaller.
std::vector<std::uint16_t> row_sums(const Signature& signature);

// What does not change when the scan turns, the cheaper the coarser. The L1 distance of each is a
// lower bound of the shifted distance.

/// Sums of each column.
std::vector<std::uint16_t> column_sums(const Signature& signature);
/// Sums of groups of neighbouring columns.
constexpr std::size_t kColumnGroups = 8;
using GroupSums = std::array<std::uint16_t, kColumnGroups>;
GroupSums group_sums(const Signature& signature);
/// The cells, each column sorted: sorting both sides minimises sum |a_i - b_pi(i)| over all
/// permutations pi, and shifts are permutations.
std::vector<std::uint8_t> sorted_columns(const Signature& signature);

/// A signature that many others are compared with.
class SignatureQuery {
 public:
  explicit SignatureQuery(const Signature& signature);

  /// Shifted distance to a signature of the same shape with the given row sums: the shifts in the
  /// order of their lower bounds, until no bound is below the least distance found.
  ShiftedDistance distance_to(const std::uint8_t* cells, const std::uint16_t* rows) const;

  const std::vector<std::uint16_t>& columns() const { return columns_; }
  const std::vector<std::uint8_t>& sorted() const { return sorted_; }
  const GroupSums& groups() const { return groups_; }

 private:
  int rows_;
  std::size_t row_size_;
  std::size_t size_;
  std::vector<std::uint8_t> twice_;  // rows 0 .. n-1, 0 .. n-1: every shift lies in one piece
  std::vector<std::uint16_t> rows_twice_;
  std::vector<std::uint16_t> columns_;
  std::vector<std::uint8_t> sorted_;
  GroupSums groups_;
};

}  // namespace falko_slam
