// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/monte_carlo.hpp"

#include <algorithm>
#include <vector>

#include "falko_slam/common/parallel_work.hpp"
#include "noise_mixture.hpp"

namespace falko_slam {
namespace {

// Covariance of the best estimate there can be from segments seen as well as these.
CalibrationVector bound_of(const std::vector<PathSegment>& segments,
                           const MonteCarloParams& params) {
  StretchSet set;
  for (const PathSegment& segment : segments) {
    set.stretches.push_back(stretch_of(segment));
    set.phases.push_back(static_cast<std::size_t>(phase_of(segment)));
  }
  set.used.assign(segments.size(), true);
  const CalibratorParams& calibrator = params.calibrator;
  const FreeParameters free = free_parameters(
      {calibrator.model, calibrator.free_wheelbase, calibrator.free_steer_gain}, params.truth);
  CalibrationNoise noise;
  noise.slip = params.noise.slip;
  noise.steer = params.noise.steer;
  noise.common_slip = params.noise.common_slip;
  noise.common_steer = params.noise.common_steer;
  const Eigen::MatrixXd covariance = estimate_with(set, free, params.truth, noise).covariance;
  return (free.columns * covariance * free.columns.transpose()).diagonal();
}

struct Outcome {
  CalibrationResult result;
  CalibrationVector bound;
};

}  // namespace

MonteCarloReport run_monte_carlo(const CalibrationCondition& condition,
                                 const MonteCarloParams& params) {
  validate(condition);
  validate(params);
  constexpr int kChunk = 128;  // drives that are kept at once
  std::mt19937_64 random(params.seed);
  CalibrationTally tally(params.truth);
  for (int done = 0; done < params.runs; done += kChunk) {
    std::vector<std::vector<PathSegment>> drives;
    for (int run = done; run < std::min(done + kChunk, params.runs); ++run) {
      drives.push_back(simulate_calibration_drive(condition, params, random));
    }
    std::vector<Outcome> outcomes(drives.size());
    do_in_parallel(drives.size(), static_cast<std::size_t>(params.threads), [&](std::size_t i) {
      outcomes[i] = {calibrate(drives[i], params.calibrator), bound_of(drives[i], params)};
    });
    for (const Outcome& outcome : outcomes) tally.add(outcome.result, outcome.bound);
  }
  return {condition,       tally.statistics(),    tally.runs(),
          tally.refused(), tally.outlier_share(), tally.mean_chi2()};
}

}  // namespace falko_slam
