// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/error_summary.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

struct Moments {
  double mean = 0.0;
  double standard_deviation = 0.0;
};

Moments moments_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Moments moments;
  for (const double value : values) moments.mean += value / count;
  double variance = 0.0;
  for (const double value : values) {
    variance += (value - moments.mean) * (value - moments.mean) / count;
  }
  moments.standard_deviation = std::sqrt(variance);
  return moments;
}

// Of sorted values; of two in the middle their mean.
double median_of(const std::vector<double>& values) {
  const std::size_t middle = values.size() / 2;
  if (values.size() % 2 == 1) return values[middle];
  return 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

ErrorSummary summarise(std::vector<double> errors) {
  if (errors.empty()) return {};
  for (double& error : errors) error = std::abs(error);
  std::sort(errors.begin(), errors.end());
  ErrorSummary summary;
  summary.count = errors.size();
  summary.median = median_of(errors);
  summary.max = errors.back();
  summary.max_square = summary.max * summary.max;
  const Moments absolute = moments_of(errors);
  for (double& error : errors) error *= error;
  const Moments square = moments_of(errors);
  summary.mean = absolute.mean;
  summary.standard_deviation = absolute.standard_deviation;
  summary.mean_square = square.mean;
  summary.square_standard_deviation = square.standard_deviation;
  summary.rms = std::sqrt(square.mean);
  return summary;
}

}  // namespace falko_slam
