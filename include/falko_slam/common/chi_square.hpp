// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace falko_slam {

/// Logarithm of the gamma function of x > 0, \cite abramowitz1964, 6.1.15 and 6.1.41. std::lgamma
/// writes to a variable that all threads share.
inline double log_gamma(double x) {
  double product = 1.0;
  for (; x < 32.0; x += 1.0) product *= x;
  const double z = 1.0 / (x * x);
  const double series = (1.0 / 12.0 - z * (1.0 / 360.0 - z * (1.0 / 1260.0 - z / 1680.0))) / x;
  constexpr double kHalfLogTwoPi = 0.918938533204672741780;
  return (x - 0.5) * std::log(x) - x + kHalfLogTwoPi + series - std::log(product);
}

/// Probability that a chi-square variable of so many degrees of freedom is greater than x: the
/// regularized incomplete gamma function Q(n / 2, x / 2), \cite abramowitz1964, 6.5.29 and 6.5.31.
inline double chi_square_tail(double x, int degrees_of_freedom) {
  const double a = 0.5 * degrees_of_freedom, z = 0.5 * x;
  if (!(z > 0.0) || degrees_of_freedom <= 0) return 1.0;
  const double front = std::exp(a * std::log(z) - z - log_gamma(a));
  if (z < a + 1.0) {
    double term = 1.0 / a, sum = term;
    for (int i = 1; i < 10000 && term > 1e-16 * sum; ++i) sum += term *= z / (a + i);
    return 1.0 - front * sum;
  }
  double b = z + 1.0 - a, c = 1e300, d = 1.0 / b, fraction = d;  // Lentz's way
  for (int i = 1; i < 10000; ++i) {
    const double step = -i * (i - a);
    b += 2.0;
    d = 1.0 / (step * d + b);
    c = b + step / c;
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < 1e-15) break;
  }
  return front * fraction;
}

/// What it is greater than with this probability, in (0, 1).
inline double chi_square_bound(double tail, int degrees_of_freedom) {
  double low = 0.0, high = 1.0;
  while (chi_square_tail(high, degrees_of_freedom) > tail) high *= 2.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (chi_square_tail(middle, degrees_of_freedom) > tail ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace falko_slam
