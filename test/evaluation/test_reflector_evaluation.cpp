// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/reflector_evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/simulation/scenario_file.hpp"

namespace falko_slam {
namespace {

ReflectorEvaluation evaluate(const std::string& scenario) {
  ReflectorEvaluationParams params;
  params.duration = 100.0;
  return evaluate_reflectors(
      read_scenario(FALKO_SLAM_SOURCE_DIR "/config/scenarios/" + scenario + ".yaml"), params);
}

// The scanner's own report is biased towards the scanner, and says nothing of its errors.
void expect_consistent(const ReflectorEvaluation& evaluation) {
  EXPECT_EQ(evaluation.strangers, 0U);
  EXPECT_LT(evaluation.missed, evaluation.reported / 12);
  int bands = 0;
  for (const ReflectorBand& band : evaluation.bands) {
    const ReflectorErrors& found = band.found;
    if (band.from < 2.0 || band.from > 20.0 || found.count < 100) continue;
    ++bands;
    EXPECT_LT(std::abs(found.along_bias), 0.002) << band.from << " m";
    EXPECT_LT(found.along_rms, band.reported.along_rms) << band.from << " m";
    // Two degrees of freedom; a drive sees the same few reflectors again and again, so that their
    // errors are not independent. Near ones are better than they claim.
    EXPECT_GT(found.nees, 0.5) << band.from << " m";
    EXPECT_LT(found.nees, 3.0) << band.from << " m";
  }
  EXPECT_GE(bands, 3);
}

TEST(ReflectorEvaluation, IsConsistentInTheCalibrationArea) {
  const ReflectorEvaluation evaluation = evaluate("calibration_area");
  EXPECT_EQ(evaluation.scans, 200U);
  expect_consistent(evaluation);
}

TEST(ReflectorEvaluation, IsConsistentInTheWarehouse) { expect_consistent(evaluate("warehouse")); }

TEST(ReflectorEvaluation, NamesFieldAndValueOfWhatIsWrong) {
  ReflectorEvaluationParams params;
  params.every = 0;
  try {
    evaluate_reflectors({}, params);
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "every = 0: must be in [1, 1000]");
  }
}

}  // namespace
}  // namespace falko_slam
