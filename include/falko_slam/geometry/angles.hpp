// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace falko_slam {

constexpr double kPi = 3.141592653589793238462643383279502884;
constexpr double kTwoPi = 2.0 * kPi;

constexpr double degrees_to_radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double radians_to_degrees(double radians) { return radians * (180.0 / kPi); }

/// The same direction in [-pi, pi), the one wrap convention of this package.
inline double wrap_angle(double angle) {
  const double wrapped = angle - kTwoPi * std::floor((angle + kPi) / kTwoPi);
  return wrapped < kPi ? wrapped : wrapped - kTwoPi;  // rounding may land on +pi
}

/// Signed shortest rotation that turns direction `from` into direction `to`, in [-pi, pi).
inline double angle_between(double from, double to) { return wrap_angle(to - from); }

}  // namespace falko_slam
