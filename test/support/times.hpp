// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/common/time.hpp"

namespace falko_slam {
namespace test {

inline Time at_seconds(double seconds) { return Time(from_seconds(seconds)); }

/// Of a vehicle's controller.
constexpr Duration kControlPeriod = std::chrono::milliseconds(20);

}  // namespace test
}  // namespace falko_slam
