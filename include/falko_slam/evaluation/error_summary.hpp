// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace falko_slam {

/// What a set of errors comes to: of their absolute values and, as \cite kuemmerle2009 lists them
/// too, of their squares. Standard deviations are those of the set itself (divided by n).
struct ErrorSummary {
  std::size_t count = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;
  double median = 0.0;
  double max = 0.0;
  double mean_square = 0.0;
  double square_standard_deviation = 0.0;
  double max_square = 0.0;
  double rms = 0.0;  ///< root of mean_square
};

/// All zero for no errors.
ErrorSummary summarise(std::vector<double> errors);

/// Errors of poses: one entry each per pose.
struct PoseErrors {
  std::vector<double> translation;  ///< [m], not negative
  std::vector<double> rotation;     ///< [rad], not negative
};

}  // namespace falko_slam
