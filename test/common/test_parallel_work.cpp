// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/parallel_work.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace falko_slam {
namespace {

TEST(ParallelWork, DoesEachOnce) {
  for (const std::size_t threads : {0U, 1U, 2U, 7U}) {
    std::vector<int> done(100, 0);
    do_in_parallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(100, 1)) << threads;
  }
}

TEST(ParallelWork, HasNothingToDoForNone) {
  do_in_parallel(0, 4, [](std::size_t) { ADD_FAILURE(); });
}

TEST(ParallelWork, ThrowsWhatTheWorkThrows) {
  for (const std::size_t threads : {1U, 3U}) {
    const auto work = [](std::size_t i) {
      if (i == 5) throw std::runtime_error("the fifth");
    };
    EXPECT_THROW(do_in_parallel(50, threads, work), std::runtime_error) << threads;
  }
}

}  // namespace
}  // namespace falko_slam
