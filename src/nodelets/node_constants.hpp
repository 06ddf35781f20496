// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "falko_slam/common/time.hpp"

namespace falko_slam {

/// Messages that wait to be taken, or sent.
inline constexpr std::uint32_t kQueue = 100;
/// Of encoders and odometry: counters are sums, but arcs are better short.
inline constexpr std::uint32_t kMotionQueue = 1000;
/// The same warning does not come again before this [s].
inline constexpr double kWarningPeriod = 5.0;
/// A stamp, or time itself, that is earlier by more than this tells of a clock that was set back.
inline constexpr Duration kClockTolerance = std::chrono::seconds(1);

}  // namespace falko_slam
