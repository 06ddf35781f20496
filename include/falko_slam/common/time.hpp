// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

namespace falko_slam {

/// Clock of the recorded data. It has no `now()`: the core never asks for the current time.
struct SensorClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<SensorClock>;
  static constexpr bool is_steady = false;
};

using Duration = SensorClock::duration;  ///< integer nanoseconds
using Time = SensorClock::time_point;    ///< integer nanoseconds since the epoch of the recording

/// Rounds to the nearest nanosecond; the argument must be finite and below 292 years.
inline Duration from_seconds(double seconds) {
  const double nanoseconds = seconds * 1e9;
  return Duration(static_cast<std::int64_t>(nanoseconds + (nanoseconds < 0.0 ? -0.5 : 0.5)));
}

inline double to_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace falko_slam
