// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace falko_slam {
namespace test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace test
}  // namespace falko_slam
