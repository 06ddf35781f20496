// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/signature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

Signature random_signature(int rows, int columns, std::mt19937_64& random) {
  Signature signature{rows, columns, {}};
  for (int i = 0; i < rows * columns; ++i) {
    signature.cells.push_back(static_cast<std::uint8_t>(random() % 256));
  }
  return signature;
}

Signature turned(const Signature& signature, int shift) {
  Signature result = signature;
  for (int row = 0; row < signature.rows; ++row) {
    for (int column = 0; column < signature.columns; ++column) {
      const int to = (row + shift) % signature.rows;
      result.cells[static_cast<std::size_t>(to * signature.columns + column)] =
          signature.at(row, column);
    }
  }
  return result;
}

// Equation (4.2) as it stands.
ShiftedDistance by_brute_force(const Signature& a, const Signature& b) {
  ShiftedDistance best{std::numeric_limits<std::uint32_t>::max(), 0};
  for (int k = 0; k < a.rows; ++k) {
    std::uint32_t sum = 0;
    for (int t = 0; t < a.rows; ++t) {
      for (int r = 0; r < a.columns; ++r) {
        sum += static_cast<std::uint32_t>(std::abs(a.at(t, r) - b.at((t + k) % a.rows, r)));
      }
    }
    if (sum < best.distance) best = {sum, k};
  }
  return best;
}

TEST(ShiftedDistance, IsTheSmallestOverAllShifts) {
  auto random = test::seeded_random();
  for (const auto& [rows, columns] :
       {std::pair(1, 1), std::pair(8, 50), std::pair(8, 37), std::pair(64, 3), std::pair(5, 16)}) {
    for (int i = 0; i < 20; ++i) {
      const Signature a = random_signature(rows, columns, random);
      const Signature b = random_signature(rows, columns, random);
      const ShiftedDistance expected = by_brute_force(a, b);
      const ShiftedDistance found = shifted_distance(a, b);
      EXPECT_EQ(found.distance, expected.distance);
      EXPECT_EQ(found.shift, expected.shift);
    }
  }
}

TEST(ShiftedDistance, OfATurnedCopyIsZeroAndTellsTheTurn) {
  auto random = test::seeded_random();
  const Signature a = random_signature(8, 50, random);
  for (int k = 0; k < 8; ++k) {
    const ShiftedDistance found = shifted_distance(a, turned(a, k));
    EXPECT_EQ(found.distance, 0U);
    EXPECT_EQ(found.shift, k);
  }
}

TEST(ShiftedDistance, IsAMetric) {
  auto random = test::seeded_random();
  for (int i = 0; i < 50; ++i) {
    const Signature a = random_signature(8, 10, random);
    const Signature b = random_signature(8, 10, random);
    const Signature c = random_signature(8, 10, random);
    const auto ab = shifted_distance(a, b).distance;
    EXPECT_EQ(ab, shifted_distance(b, a).distance);
    EXPECT_LE(ab, shifted_distance(a, c).distance + shifted_distance(c, b).distance);
  }
}

TEST(L1Distance, SumsTheDifferences) {
  const Signature a{2, 2, {0, 255, 3, 4}};
  const Signature b{2, 2, {255, 0, 5, 4}};
  EXPECT_EQ(l1_distance(a, b), 512U);
}

TEST(Signature, OfOtherShapeIsRefused) {
  const Signature a{2, 2, {0, 0, 0, 0}};
  const Signature b{1, 4, {0, 0, 0, 0}};
  EXPECT_THROW(l1_distance(a, b), std::invalid_argument);
  EXPECT_THROW(shifted_distance(a, b), std::invalid_argument);
  EXPECT_THROW(joined(a, b), std::invalid_argument);
}

TEST(Signature, JoinedHasTheRowsSideBySide) {
  const Signature left{2, 2, {1, 2, 3, 4}};
  const Signature right{2, 1, {5, 6}};
  const Signature both = joined(left, right);
  EXPECT_EQ(both.rows, 2);
  EXPECT_EQ(both.columns, 3);
  EXPECT_EQ(both.cells, (std::vector<std::uint8_t>{1, 2, 5, 3, 4, 6}));
}

TEST(Signature, IsEmptyWithoutAnyCellSet) {
  EXPECT_TRUE((Signature{1, 2, {0, 0}}).empty());
  EXPECT_FALSE((Signature{1, 2, {0, 1}}).empty());
}

}  // namespace
}  // namespace falko_slam
