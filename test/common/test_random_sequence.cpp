// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/random_sequence.hpp"

#include <gtest/gtest.h>

#include <set>

namespace falko_slam {
namespace {

TEST(RandomSequence, IsTheSameForTheSameSeedAndPartOnly) {
  EXPECT_EQ(random_sequence(7, {1})(), random_sequence(7, {1})());
  std::set<std::uint64_t> first;
  for (const std::uint64_t seed : {std::uint64_t{7}, std::uint64_t{8}, std::uint64_t{7} << 32U}) {
    for (const std::uint32_t part : {0U, 1U, 2U}) {
      first.insert(random_sequence(seed, {part})());
      first.insert(random_sequence(seed, {part, 1U})());
    }
  }
  EXPECT_EQ(first.size(), 18U);
}

}  // namespace
}  // namespace falko_slam
