// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "stretch_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "calibration/arc_drives.hpp"
#include "falko_slam/calibration/monte_carlo.hpp"

namespace falko_slam {
namespace {

StretchSet simulated_set() {
  StretchSet set;
  auto random = test::seeded_random();
  for (const PathSegment& segment :
       simulate_calibration_drive(thesis_conditions()[5], MonteCarloParams(), random)) {
    set.stretches.push_back(stretch_of(segment));
    set.phases.push_back(static_cast<std::size_t>(phase_of(segment)));
    set.used.push_back(true);
  }
  return set;
}

CalibrationNoise without_common_errors() {
  CalibrationNoise noise;
  noise.common_slip = noise.common_steer = 0.0;
  return noise;
}

// The whole cost written out, with the weights of one place.
double cost_of(const StretchSet& set, const VehicleCalibration& calibration,
               const VehicleCalibration& weights_of) {
  double sum = 0.0;
  for (const MeasuredStretch& stretch : set.stretches) {
    const Eigen::Matrix3d covariance =
        residual_covariance(stretch, predict(weights_of, stretch.arcs), without_common_errors());
    const Eigen::Vector3d residual = stretch.motion - predict(calibration, stretch.arcs).motion;
    sum += residual.dot(covariance.llt().solve(residual));
  }
  return sum;
}

TEST(StretchFit, IsAMinimumWhereverOneGoesFromThere) {
  const StretchSet set = simulated_set();
  const FreeParameters free = free_parameters({}, test::cb16());
  const VehicleCalibration at =
      fit(set, free, test::cb16(), without_common_errors(), FitLoss::kNone).calibration;
  const double least = cost_of(set, at, at);
  auto random = test::seeded_random();
  for (int i = 0; i < 1000; ++i) {
    Eigen::VectorXd step(free.count());
    for (Eigen::Index k = 0; k < step.size(); ++k) step[k] = test::normal(random, 1e-5);
    const CalibrationVector moved = vector_of(at) + free.columns * step;
    EXPECT_GE(cost_of(set, calibration_of(moved), at), least);
  }
}

TEST(StretchFit, MovesBothOffsetsAlikeInTheStandardModel) {
  const FreeParameters free =
      free_parameters({TricycleModel::kStandard, false, false}, test::cb16());
  EXPECT_EQ(free.count(), 5);
  EXPECT_EQ(free.columns(0, 0), 1.0);
  EXPECT_EQ(free.columns(1, 0), 1.0);
  EXPECT_EQ(free_parameters({TricycleModel::kAsymmetric, true, true}, test::cb16()).count(), 8);
}

TEST(StretchFit, GivesWhatAPhaseHasInCommonToThePhase) {
  StretchSet set = simulated_set();
  for (std::size_t i = 0; i < set.stretches.size(); ++i) {
    if (set.phases[i] == 1) set.stretches[i].arcs[0].ticks /= 1.01;
  }
  const FreeParameters free = free_parameters({}, test::cb16());
  const StretchFit fitted = fit(set, free, test::cb16(), CalibrationNoise(), FitLoss::kCauchy);
  EXPECT_TRUE(fitted.converged);
  EXPECT_NEAR(fitted.common[1].slip - fitted.common[0].slip, 0.01, 0.002);
}

}  // namespace
}  // namespace falko_slam
