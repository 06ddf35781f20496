// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/log_trouble.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

TEST(LogTrouble, IsSilentIfThereIsNone) { EXPECT_EQ(describe_trouble(0, {}), ""); }

TEST(LogTrouble, CountsAndListsSome) {
  EXPECT_EQ(describe_trouble(2, {7}),
            "; 2 stamps run backward (file order kept); 1 malformed lines left out: 7");
  EXPECT_EQ(describe_trouble(0, {1, 2, 3, 4, 5}), "; 5 malformed lines left out: 1 2 3 4 5");
  EXPECT_EQ(describe_trouble(0, {1, 2, 3, 4, 5, 9}), "; 6 malformed lines left out: 1 2 3 4 5 ...");
}

}  // namespace
}  // namespace falko_slam
