// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/features/descriptors.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

TEST(BscDistance, CountsDifferingCells) {
  EXPECT_EQ(distance(Bsc{{0x0FU, 1U}}, Bsc{{0x3CU, 0U}}), 5);
  EXPECT_EQ(distance(Bsc{{7U}}, Bsc{{7U}}), 0);
}

TEST(CghDistance, IsAMetricLikeMeasure) {
  auto random = test::seeded_random();
  const auto histogram = [&] {
    Cgh cgh;
    float sum = 0.0F;
    for (int i = 0; i < 16; ++i) {
      cgh.bins.push_back(static_cast<float>(test::uniform(random, 0.0, 1.0)));
      sum += cgh.bins.back();
    }
    for (float& bin : cgh.bins) bin /= sum;
    return cgh;
  };
  for (int i = 0; i < 100; ++i) {
    const Cgh a = histogram();
    const Cgh b = histogram();
    EXPECT_EQ(distance(a, a), 0.0);
    EXPECT_EQ(distance(a, b), distance(b, a));
    EXPECT_GT(distance(a, b), 0.0);
    EXPECT_LE(distance(a, b), 1.0);
  }
}

TEST(CghDistance, IsOneForDisjointHistograms) {
  EXPECT_NEAR(distance(Cgh{{1.0F, 0.0F}}, Cgh{{0.0F, 1.0F}}), 1.0, 1e-9);
  EXPECT_EQ(distance(Cgh{{0.0F, 0.0F}}, Cgh{{0.0F, 0.0F}}), 0.0);
}

TEST(DescriptorDistance, RefusesDifferentSizes) {
  EXPECT_THROW(distance(Bsc{{1U}}, Bsc{{1U, 2U}}), std::invalid_argument);
  EXPECT_THROW(distance(Cgh{{1.0F}}, Cgh{{0.5F, 0.5F}}), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
