// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "signature_query.hpp"

#include <algorithm>
#include <limits>

namespace falko_slam {
namespace {

constexpr unsigned kLargest = std::numeric_limits<std::uint16_t>::max();

std::uint16_t saturated(unsigned sum) {
  return static_cast<std::uint16_t>(std::min(sum, kLargest));
}

template <class Cell>
std::vector<Cell> twice(const std::vector<Cell>& cells) {
  std::vector<Cell> result = cells;
  result.insert(result.end(), cells.begin(), cells.end());
  return result;
}

}  // namespace

std::vector<std::uint16_t> row_sums(const Signature& signature) {
  std::vector<std::uint16_t> sums;
  for (int row = 0; row < signature.rows; ++row) {
    unsigned sum = 0;
    for (int column = 0; column < signature.columns; ++column) sum += signature.at(row, column);
    sums.push_back(saturated(sum));
  }
  return sums;
}

std::vector<std::uint16_t> column_sums(const Signature& signature) {
  std::vector<std::uint16_t> sums;
  for (int column = 0; column < signature.columns; ++column) {
    unsigned sum = 0;
    for (int row = 0; row < signature.rows; ++row) sum += signature.at(row, column);
    sums.push_back(saturated(sum));
  }
  return sums;
}

GroupSums group_sums(const Signature& signature) {
  const std::vector<std::uint16_t> columns = column_sums(signature);
  std::array<unsigned, kColumnGroups> sums{};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    sums[c * kColumnGroups / columns.size()] += columns[c];
  }
  GroupSums groups{};
  std::transform(sums.begin(), sums.end(), groups.begin(), saturated);
  return groups;
}

std::vector<std::uint8_t> sorted_columns(const Signature& signature) {
  std::vector<std::uint8_t> sorted = signature.cells;
  std::vector<std::uint8_t> column(static_cast<std::size_t>(signature.rows));
  const auto columns = static_cast<std::size_t>(signature.columns);
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t r = 0; r < column.size(); ++r) column[r] = sorted[r * columns + c];
    std::sort(column.begin(), column.end());
    for (std::size_t r = 0; r < column.size(); ++r) sorted[r * columns + c] = column[r];
  }
  return sorted;
}

SignatureQuery::SignatureQuery(const Signature& signature)
    : rows_(signature.rows),
      row_size_(static_cast<std::size_t>(signature.columns)),
      size_(signature.cells.size()),
      twice_(twice(signature.cells)),
      rows_twice_(twice(row_sums(signature))),
      columns_(column_sums(signature)),
      sorted_(sorted_columns(signature)),
      groups_(group_sums(signature)) {}

ShiftedDistance SignatureQuery::distance_to(const std::uint8_t* cells,
                                            const std::uint16_t* rows) const {
  constexpr int kMaxRows = 64;
  const int shifts = std::min(rows_, kMaxRows);
  std::uint32_t bounds[kMaxRows];
  int likeliest = 0;
  for (int shift = 0; shift < shifts; ++shift) {
    bounds[shift] = l1_distance(rows, rows_twice_.data() + shift, static_cast<std::size_t>(rows_));
    if (bounds[shift] < bounds[likeliest]) likeliest = shift;
  }
  ShiftedDistance best{std::numeric_limits<std::uint32_t>::max(), 0};
  const auto look_at = [&](int shift, std::uint32_t bound) {
    if (bound > best.distance) return;
    const std::uint8_t* shifted = twice_.data() + static_cast<std::size_t>(shift) * row_size_;
    const std::uint32_t distance = l1_distance(cells, shifted, size_);
    if (distance < best.distance || (distance == best.distance && shift < best.shift)) {
      best = {distance, shift};
    }
  };
  if (rows_ > 0) look_at(likeliest, bounds[likeliest]);
  for (int shift = 0; shift < rows_; ++shift) {
    if (shift != likeliest) look_at(shift, shift < shifts ? bounds[shift] : 0);
  }
  return rows_ > 0 ? best : ShiftedDistance{};
}

}  // namespace falko_slam
