// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/chi_square.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace falko_slam {
namespace {

// \cite abramowitz1964, table 26.8.
TEST(ChiSquare, HasTheBoundsOfTheTables) {
  EXPECT_NEAR(chi_square_bound(0.05, 1), 3.84146, 1e-5);
  EXPECT_NEAR(chi_square_bound(0.001, 3), 16.266, 1e-3);
  EXPECT_NEAR(chi_square_bound(0.95, 10), 3.94030, 1e-5);
  EXPECT_NEAR(chi_square_bound(0.01, 100), 135.807, 1e-3);
  EXPECT_NEAR(chi_square_tail(2.0, 2), std::exp(-1.0), 1e-14);
  EXPECT_EQ(chi_square_tail(0.0, 5), 1.0);
}

TEST(LogGamma, IsTheLogarithmOfFactorials) {
  double factorial = 1.0;
  for (int n = 1; n < 100; factorial *= n++) {
    EXPECT_NEAR(log_gamma(n), std::log(factorial), 5e-14 * std::max(1.0, std::log(factorial))) << n;
  }
}

TEST(LogGamma, IsTheLibrarysBetweenThem) {
  for (double x = 0.01; x < 1e6; x *= 1.3) {
    EXPECT_NEAR(log_gamma(x), std::lgamma(x), 5e-14 * std::max(1.0, std::abs(std::lgamma(x)))) << x;
  }
}

}  // namespace
}  // namespace falko_slam
