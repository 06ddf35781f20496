// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "box_smoothing.hpp"

#include <algorithm>

namespace falko_slam {
namespace {

// Samples nearer than this share of the width to an end count as the end.
constexpr double kShortest = 1e-6;

}  // namespace

BoxSmoothing::Place BoxSmoothing::place_at(double abscissa, std::size_t hint) const {
  std::size_t sample = hint;
  while (sample + 2 < size_ && abscissas_[sample + 1] <= abscissa) ++sample;
  const double step = abscissas_[sample + 1] - abscissas_[sample];
  const double share = step > 0.0 ? (abscissa - abscissas_[sample]) / step : 0.0;
  return {sample, std::clamp(share, 0.0, 1.0)};
}

void BoxSmoothing::assign(const double* begin, const double* end, double width) {
  abscissas_ = begin;
  size_ = static_cast<std::size_t>(end - begin);
  windows_.assign(size_, {{0, 0.0}, {0, 0.0}, 0.0});
  if (size_ < 2) return;
  std::size_t from = 0;
  std::size_t to = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double reach = std::min({width, begin[i] - begin[0], begin[size_ - 1] - begin[i]});
    if (reach <= kShortest * width) continue;
    Window& window = windows_[i];
    window.from = place_at(begin[i] - reach, from);
    window.to = place_at(begin[i] + reach, to);
    window.inverse_length = 0.5 / reach;
    from = window.from.sample;
    to = window.to.sample;
  }
}

double BoxSmoothing::integral_to(const Place& place, const double* values) const {
  const std::size_t i = place.sample;
  const double step = place.share * (abscissas_[i + 1] - abscissas_[i]);
  return integral_[i] + step * (values[i] + 0.5 * place.share * (values[i + 1] - values[i]));
}

void BoxSmoothing::operator()(double* values) {
  if (size_ < 2) return;
  integral_.resize(size_);
  integral_[0] = 0.0;
  for (std::size_t i = 1; i < size_; ++i) {
    integral_[i] =
        integral_[i - 1] + 0.5 * (abscissas_[i] - abscissas_[i - 1]) * (values[i] + values[i - 1]);
  }
  means_.resize(size_);
  for (std::size_t i = 0; i < size_; ++i) {
    const Window& window = windows_[i];
    means_[i] = window.inverse_length == 0.0
                    ? values[i]
                    : window.inverse_length *
                          (integral_to(window.to, values) - integral_to(window.from, values));
  }
  std::copy(means_.begin(), means_.end(), values);
}

}  // namespace falko_slam
