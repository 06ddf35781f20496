// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/signature.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "signature_query.hpp"

namespace falko_slam {
namespace {

std::string shape(const Signature& s) {
  return std::to_string(s.rows) + " x " + std::to_string(s.columns);
}

void require_same_shape(const Signature& a, const Signature& b) {
  if (a.rows == b.rows && a.columns == b.columns) return;
  throw std::invalid_argument("signatures of " + shape(a) + " and " + shape(b) + " cells");
}

}  // namespace

bool Signature::empty() const {
  return std::all_of(cells.begin(), cells.end(), [](std::uint8_t cell) { return cell == 0; });
}

Signature joined(const Signature& left, const Signature& right) {
  if (left.rows != right.rows) {
    throw std::invalid_argument("signatures of " + std::to_string(left.rows) + " and " +
                                std::to_string(right.rows) + " rows");
  }
  Signature both;
  both.rows = left.rows;
  both.columns = left.columns + right.columns;
  for (int row = 0; row < both.rows; ++row) {
    for (const Signature* part : {&left, &right}) {
      const auto begin = part->cells.begin() + static_cast<std::ptrdiff_t>(row) * part->columns;
      both.cells.insert(both.cells.end(), begin, begin + part->columns);
    }
  }
  return both;
}

std::uint32_t l1_distance(const Signature& a, const Signature& b) {
  require_same_shape(a, b);
  return l1_distance(a.cells.data(), b.cells.data(), a.cells.size());
}

ShiftedDistance shifted_distance(const Signature& a, const Signature& b) {
  require_same_shape(a, b);
  const SignatureQuery query(b);
  return query.distance_to(a.cells.data(), row_sums(a).data());
}

}  // namespace falko_slam
