// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/monte_carlo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "calibration/arc_drives.hpp"
#include "falko_slam/calibration/calibration_tally.hpp"
#include "falko_slam/common/chi_square.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kFixedWheelbase = 6;  // parameters that are not held

MonteCarloParams known_noise(int runs) {
  MonteCarloParams params;
  params.runs = runs;
  params.calibrator.noise.common_slip = params.calibrator.noise.common_steer = 0.0;
  params.calibrator.noise.unknown_factor = 1.0;
  return params;
}

TEST(ThesisConditions, AreThe20RowsOfTheTables) {
  const auto conditions = thesis_conditions();
  ASSERT_EQ(conditions.size(), 20U);
  for (const CalibrationCondition& condition : conditions) EXPECT_NO_THROW(validate(condition));
  EXPECT_EQ(conditions[0].arcs_per_phase, 2);
  EXPECT_NEAR(conditions[2].turn, kPi / 3.0, 1e-12);
  EXPECT_NEAR(conditions[8].min_steering, degrees_to_radians(35.0), 1e-12);
  EXPECT_NEAR(conditions[18].turn, kPi / 0.75, 1e-12);
  EXPECT_NEAR(conditions[19].wheel_speed, 0.8, 1e-12);
}

// Of so many runs the variance scatters as chi2 does; so far out it is once in 10 000 times.
TEST(MonteCarlo, ReachesTheCramerRaoBound) {
  constexpr int kRuns = 300;
  const double low = std::sqrt(chi_square_bound(1.0 - 1e-4, kRuns - 1) / (kRuns - 1));
  const double high = std::sqrt(chi_square_bound(1e-4, kRuns - 1) / (kRuns - 1));
  for (const std::size_t row : {0U, 2U, 5U, 18U}) {
    const auto report = run_monte_carlo(thesis_conditions()[row], known_noise(kRuns));
    EXPECT_EQ(report.runs, kRuns);
    EXPECT_LT(report.outlier_share, 1e-3);
    EXPECT_NEAR(report.mean_chi2, 1.0, 0.05);
    for (std::size_t i = 0; i < kFixedWheelbase; ++i) {
      const ParameterStatistics& parameter = report.parameters[i];
      EXPECT_GT(parameter.deviation, low * parameter.bound) << row << " " << i;
      EXPECT_LT(parameter.deviation, high * parameter.bound) << row << " " << i;
      EXPECT_LT(std::abs(parameter.bias), 4.0 / std::sqrt(kRuns) * parameter.bound);
      EXPECT_GT(parameter.closed_form_deviation, 0.95 * parameter.deviation);
      EXPECT_GT(parameter.coverage, 0.90) << row << " " << i;
      EXPECT_LT(parameter.coverage, 0.99) << row << " " << i;
    }
  }
}

// What the bound is for the fifth and the second row of Table 5.1, once computed elsewhere.
TEST(MonteCarlo, HasTheBoundsOfAnIndependentSimulation) {
  const double unit[6] = {5729.578, 5729.578, 1e8, 1e3, 1e3, 5729.578};  // cdeg, 1e-5 mm/tick, mm
  const double expected[2][6] = {{0.57, 0.57, 3.7, 0.43, 0.56, 0.93},
                                 {0.50, 0.50, 3.8, 0.42, 0.62, 0.79}};
  for (const std::size_t row : {0U, 1U}) {
    const auto report = run_monte_carlo(thesis_conditions()[row == 0 ? 5 : 1], known_noise(20));
    for (std::size_t i = 0; i < kFixedWheelbase; ++i) {
      EXPECT_NEAR(unit[i] * report.parameters[i].bound / expected[row][i], 1.0, 0.08) << i;
    }
  }
}

// Where phases slip or steer in common: the interval may widen, it may not lie.
TEST(MonteCarlo, CoversTheTruthWithCommonErrors) {
  MonteCarloParams params;
  params.runs = 100;
  params.calibrator.noise.unknown_factor = 1.0;  // less to compute
  params.noise.common_slip = 8e-4;
  params.noise.common_steer = 4e-4;

  const auto report = run_monte_carlo(thesis_conditions()[5], params);

  EXPECT_LT(report.outlier_share, 1e-2);
  for (std::size_t i = 0; i < kFixedWheelbase; ++i) {
    EXPECT_GE(report.parameters[i].coverage, 0.88) << i;  // 95 % of 100 runs, or 1 in 200
  }
}

TEST(MonteCarlo, CoversTheTruthIfTheNoiseIsNotWhatWasSaid) {
  MonteCarloParams params = known_noise(100);
  params.calibrator.noise.unknown_factor = 4.0;
  params.noise.slip *= 3.0;
  params.noise.steer *= 0.4;

  const auto report = run_monte_carlo(thesis_conditions()[5], params);

  EXPECT_LT(report.outlier_share, 1e-2);
  for (std::size_t i = 0; i < kFixedWheelbase; ++i) {
    EXPECT_GE(report.parameters[i].coverage, 0.88) << i;
  }
}

// Reflectors that look displaced, each by 5 mm, displace the laser's pose in all arcs of a phase.
// What is said of it is what ten of them leave over.
TEST(MonteCarlo, CoversTheTruthWithReflectorsThatLookDisplaced) {
  MonteCarloParams params = known_noise(100);
  params.noise.viewpoint_bias = 0.005;
  params.calibrator.noise = told_of_viewpoint_bias(params.calibrator.noise, params.noise);

  const auto report = run_monte_carlo(thesis_conditions()[5], params);

  for (std::size_t i = 0; i < kFixedWheelbase; ++i) {
    EXPECT_GE(report.parameters[i].coverage, 0.88) << i;
  }
}

TEST(MonteCarlo, IsTheSameForTheSameSeed) {
  const auto first = run_monte_carlo(thesis_conditions()[0], known_noise(3));
  const auto again = run_monte_carlo(thesis_conditions()[0], known_noise(3));
  MonteCarloParams other = known_noise(3);
  other.seed = 2;
  EXPECT_EQ(first.parameters[2].deviation, again.parameters[2].deviation);
  EXPECT_NE(first.parameters[2].deviation,
            run_monte_carlo(thesis_conditions()[0], other).parameters[2].deviation);
}

TEST(MonteCarlo, IsTheSameForAnyNumberOfThreads) {
  MonteCarloParams params = known_noise(5);
  const auto one = run_monte_carlo(thesis_conditions()[0], params);
  params.threads = 3;
  const auto three = run_monte_carlo(thesis_conditions()[0], params);
  for (std::size_t i = 0; i < kFixedWheelbase; ++i) {
    EXPECT_EQ(one.parameters[i].deviation, three.parameters[i].deviation) << i;
    EXPECT_EQ(one.parameters[i].half_width, three.parameters[i].half_width) << i;
  }
}

TEST(MonteCarlo, KnowsHowDeviationsScatter) {
  const DeviationScatter scatter = scatter_of_deviation(400);
  EXPECT_NEAR(scatter.low, std::sqrt(345.551 / 399.0), 1e-4);  // of tables of chi-square
  EXPECT_NEAR(scatter.high, std::sqrt(456.236 / 399.0), 1e-4);
}

TEST(MonteCarlo, GetsBetterWithScansAtRest) {
  MonteCarloParams params = known_noise(20);
  params.noise.scans_at_rest = 40;
  const auto report = run_monte_carlo(thesis_conditions()[5], params);
  EXPECT_LT(report.parameters[3].bound, 1e-4);
}

TEST(MonteCarlo, ChecksItsParams) {
  MonteCarloParams params = known_noise(1);
  EXPECT_THROW(run_monte_carlo(thesis_conditions()[0], params), std::invalid_argument);
  params = known_noise(2);
  params.noise.reflectors = 1;
  EXPECT_THROW(run_monte_carlo(thesis_conditions()[0], params), std::invalid_argument);
  EXPECT_THROW(run_monte_carlo({0, 0.3, 0.9, 1.0, 1.0}, known_noise(2)), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
