// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace falko_slam {

/// Means of piecewise linear signals over windows of a given length: the samples may lie at any
/// distance from each other, and the cost is that of the samples, whatever the length.
///
/// Three means over s - width to s + width are nearly a Gaussian: their standard deviation is
/// `width`, and no weight lies beyond 3 width. Where the signal ends before a window does, the
/// window shrinks on both sides, so that the ends stay where they are.
class BoxSmoothing {
 public:
  /// The windows about each of the ascending abscissas from `begin` to `end`, of which only the
  /// differences matter.
  void assign(const double* begin, const double* end, double width);

  /// Replaces the values at the abscissas by the means over their windows.
  void operator()(double* values);

 private:
  // A place between two samples: `share` of the way from `sample` to the next one.
  struct Place {
    std::size_t sample;
    double share;
  };
  struct Window {
    Place from, to;
    double inverse_length;  // 0: shorter than anything that can be averaged over
  };

  Place place_at(double abscissa, std::size_t hint) const;
  double integral_to(const Place& place, const double* values) const;

  const double* abscissas_ = nullptr;
  std::size_t size_ = 0;
  std::vector<Window> windows_;
  std::vector<double> integral_;  // from the first sample to each
  std::vector<double> means_;
};

}  // namespace falko_slam
