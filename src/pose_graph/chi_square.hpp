// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

/// The value that a chi-square variable of three degrees of freedom stays below with this
/// probability, in (0, 1). From P(x) = erf(sqrt(x / 2)) - sqrt(2 x / pi) exp(-x / 2) by bisection.
inline double chi_square_quantile_3(double probability) {
  double low = 0.0, high = 200.0;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    const double below =
        std::erf(std::sqrt(0.5 * x)) - std::sqrt(2.0 * x / kPi) * std::exp(-0.5 * x);
    (below < probability ? low : high) = x;
  }
  return 0.5 * (low + high);
}

}  // namespace falko_slam
