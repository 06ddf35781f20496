// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/error_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace falko_slam {
namespace {

TEST(ErrorSummary, IsWhatAHandComputes) {
  const ErrorSummary summary = summarise({3.0, -1.0, 2.0, 6.0});
  EXPECT_EQ(summary.count, 4U);
  EXPECT_DOUBLE_EQ(summary.mean, 3.0);
  EXPECT_DOUBLE_EQ(summary.standard_deviation, std::sqrt(14.0 / 4.0));
  EXPECT_DOUBLE_EQ(summary.median, 2.5);
  EXPECT_DOUBLE_EQ(summary.max, 6.0);
  EXPECT_DOUBLE_EQ(summary.mean_square, 12.5);  // of 1, 4, 9, 36
  EXPECT_DOUBLE_EQ(summary.square_standard_deviation,
                   std::sqrt((11.5 * 11.5 + 8.5 * 8.5 + 3.5 * 3.5 + 23.5 * 23.5) / 4.0));
  EXPECT_DOUBLE_EQ(summary.max_square, 36.0);
  EXPECT_DOUBLE_EQ(summary.rms, std::sqrt(12.5));
}

TEST(ErrorSummary, OfOneErrorIsThatError) {
  const ErrorSummary summary = summarise({-2.0});
  EXPECT_EQ(summary.mean, 2.0);
  EXPECT_EQ(summary.median, 2.0);
  EXPECT_EQ(summary.standard_deviation, 0.0);
}

TEST(ErrorSummary, OfNothingIsZero) {
  EXPECT_EQ(summarise({}).count, 0U);
  EXPECT_EQ(summarise({}).mean, 0.0);
}

}  // namespace
}  // namespace falko_slam
