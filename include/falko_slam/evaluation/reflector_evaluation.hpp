// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/simulation/scenario.hpp"

namespace falko_slam {

struct ReflectorEvaluationParams {
  /// The diameter is that of the scenario's reflectors.
  ReflectorDetectorParams detector;
  std::uint64_t seed = 1;
  int every = 4;          ///< so many scans from one that is looked at to the next. [1, 1000]
  double duration = 1e6;  ///< of the drive at most. [0.1, 1e6] [s]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const ReflectorEvaluationParams& params);

/// Errors of reflectors, found minus true, where each was seen at its own time.
struct ReflectorErrors {
  std::size_t count = 0;
  double along_bias = 0.0;   ///< mean along the line of sight [m]
  double along_rms = 0.0;    ///< [m]
  double across_bias = 0.0;  ///< mean across it, to the left [m]
  double across_rms = 0.0;   ///< [m]
  double nees = 0.0;         ///< mean of the squared Mahalanobis distance, 2 if all is as claimed
};

/// Of reflectors of one band of ranges.
struct ReflectorBand {
  double from = 0.0;  ///< [m]
  double to = 0.0;
  ReflectorErrors found;
  ReflectorErrors hidden;    ///< those of them that say that they are partly hidden
  ReflectorErrors reported;  ///< by the simulated device, of the same ones; no NEES
};

struct ReflectorEvaluation {
  std::size_t scans = 0;
  std::size_t found = 0;
  std::size_t strangers = 0;         ///< found where no reflector is
  std::size_t reported = 0;          ///< by the simulated device
  std::size_t missed = 0;            ///< reported, where a reflector is, but not found
  std::vector<ReflectorBand> bands;  ///< 0, 2, 5, 10, 15, 20, 30, 100 m
};

/// Lets a vehicle do the scenario's drive and compares what the detector finds in its scans, which
/// are skewed by the motion, with the true places. `step` is called after each scan.
ReflectorEvaluation evaluate_reflectors(
    const Scenario& scenario, const ReflectorEvaluationParams& params,
    const std::function<void()>& step = [] {});

}  // namespace falko_slam
