// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "pair_histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace falko_slam {
namespace {

Signature with_one_pair(double row, double column, PairHistogram::Rows kind) {
  PairHistogram pairs(4, 5, 0.5, kind);
  pairs.add(row, column);
  return pairs.scaled();
}

TEST(PairHistogram, SpreadsAPairEvenlyFromTheMiddleOfItsCell) {
  const Signature table = with_one_pair(1.5, 2.5, PairHistogram::Rows::kCircle);
  EXPECT_EQ(table.at(0, 2), table.at(2, 2));
  EXPECT_EQ(table.at(1, 1), table.at(1, 3));
  EXPECT_GT(table.at(1, 1), table.at(0, 1));
  EXPECT_EQ(table.at(3, 2), 0);
  EXPECT_EQ(table.at(1, 4), 0);
}

TEST(PairHistogram, GoesOnBeyondTheLastRowAsItIsTold) {
  const Signature circle = with_one_pair(3.9, 2.5, PairHistogram::Rows::kCircle);
  EXPECT_GT(circle.at(0, 2), 0);
  const Signature folded = with_one_pair(3.9, 2.5, PairHistogram::Rows::kFolded);
  EXPECT_EQ(folded.at(0, 2), 0);
  EXPECT_GT(folded.at(3, 2), 0);
}

TEST(PairHistogram, LeavesOutWhatIsTooFarOrNoNumber) {
  for (const double column : {5.0, 1e300, std::nan("")}) {
    EXPECT_TRUE(with_one_pair(1.0, column, PairHistogram::Rows::kCircle).empty()) << column;
  }
}

TEST(PairHistogram, OfNothingIsEmpty) {
  EXPECT_TRUE(PairHistogram(4, 5, 0.5, PairHistogram::Rows::kFolded).scaled().empty());
}

}  // namespace
}  // namespace falko_slam
