// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/time.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

TEST(Time, RoundsToTheNearestNanosecondOnBothSidesOfZero) {
  EXPECT_EQ(from_seconds(1.5), std::chrono::milliseconds(1500));
  EXPECT_EQ(from_seconds(1.6e-9), Duration(2));
  EXPECT_EQ(from_seconds(-1.6e-9), Duration(-2));
  EXPECT_EQ(from_seconds(-0.25), std::chrono::milliseconds(-250));
}

TEST(Time, ComesBackFromSeconds) {
  for (const double seconds : {0.0, 1e-9, -3.25, 86400.0, 1.69e9}) {
    EXPECT_NEAR(to_seconds(from_seconds(seconds)), seconds, 1e-9) << seconds;
  }
}

}  // namespace
}  // namespace falko_slam
