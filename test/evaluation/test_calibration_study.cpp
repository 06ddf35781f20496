// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/calibration_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/evaluation/thesis_calibration.hpp"

namespace falko_slam {
namespace {

MonteCarloParams few_runs() {
  MonteCarloParams params;
  params.runs = 3;
  params.calibrator.noise.common_slip = params.calibrator.noise.common_steer = 0.0;
  params.calibrator.noise.unknown_factor = 1.0;
  return params;
}

// The same vehicle was calibrated for both tables from the same drives: the pose of the laser does
// not depend on the model, so a misread digit shows.
TEST(ThesisCalibrations, TellTheSameLaserInBothTables) {
  const auto rows = thesis_calibrations();
  ASSERT_EQ(rows.size(), thesis_conditions().size());
  const auto at = [](const CalibrationVector& vector, CalibrationParameter parameter) {
    return vector[static_cast<Eigen::Index>(index_of(parameter))];
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const PublishedCalibration &stc = rows[i].standard, &atc = rows[i].asymmetric;
    for (const auto parameter :
         {CalibrationParameter::kLaserX, CalibrationParameter::kLaserTheta}) {
      EXPECT_NEAR(thesis_unit(parameter) * at(stc.mean, parameter),
                  thesis_unit(parameter) * at(atc.mean, parameter), 0.1)
          << i;
      // One is divided by n = 3, the other by 2.
      EXPECT_NEAR(at(atc.deviation, parameter) / at(stc.deviation, parameter), std::sqrt(1.5), 0.12)
          << i << " " << name_of(parameter);
    }
    EXPECT_NEAR(at(stc.mean, CalibrationParameter::kDrivingScale),
                at(atc.mean, CalibrationParameter::kDrivingScale), 2e-7)
        << i;
    EXPECT_GT(at(stc.mean, CalibrationParameter::kSteerOffsetForward),
              at(atc.mean, CalibrationParameter::kSteerOffsetBackward));
    EXPECT_LT(at(stc.mean, CalibrationParameter::kSteerOffsetForward),
              at(atc.mean, CalibrationParameter::kSteerOffsetForward));
  }
}

TEST(CalibrationStudy, MeasuresTheRowsThatAreAskedFor) {
  std::vector<std::size_t> told;
  const auto study =
      study_calibration({9, 1}, few_runs(), [&](std::size_t number) { told.push_back(number); });
  ASSERT_EQ(study.conditions.size(), 2U);
  EXPECT_EQ(told, (std::vector<std::size_t>{9, 1}));
  EXPECT_EQ(study.conditions[0].number, 9U);
  EXPECT_NEAR(study.conditions[0].report.condition.min_steering, 0.6109, 1e-4);
  EXPECT_EQ(study.conditions[1].report.condition.arcs_per_phase, 2);
}

TEST(CalibrationStudy, GivesEachRowItsOwnNoiseWhateverElseIsAskedFor) {
  const auto both = study_calibration({5, 6}, few_runs());
  const auto one = study_calibration({6}, few_runs());
  const auto deviation = [](const StudiedCondition& studied) {
    return studied.report.parameters[0].deviation;
  };
  EXPECT_EQ(deviation(both.conditions[1]), deviation(one.conditions[0]));
  EXPECT_NE(deviation(both.conditions[0]), deviation(both.conditions[1]));  // v_w alone differs
}

TEST(CalibrationStudy, SumsUpAColumn) {
  CalibrationStudy study;
  study.conditions.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    StudiedCondition& condition = study.conditions[i];
    condition.report.runs = i == 0 ? 100 : 300;
    ParameterStatistics& parameter = condition.report.parameters[0];
    parameter.deviation = i == 0 ? 3.0 : 4.0;
    parameter.bound = 2.0;
    parameter.bias = -1.5;
    parameter.coverage = i == 0 ? 0.9 : 0.98;
    condition.published.standard.deviation[0] = 3.5;
  }

  const StudiedParameter all =
      over_all(study, CalibrationParameter::kSteerOffsetForward, TricycleModel::kStandard);

  EXPECT_NEAR(all.deviation, std::sqrt(12.5), 1e-12);
  EXPECT_NEAR(all.published_deviation, 3.5, 1e-12);
  EXPECT_NEAR(all.over_bound, std::sqrt(12.5) / 2.0, 1e-12);
  EXPECT_NEAR(all.greatest_over_bound, 2.0, 1e-12);
  EXPECT_NEAR(all.greatest_bias, 0.5, 1e-12);
  EXPECT_NEAR(all.coverage, 0.96, 1e-12);
  EXPECT_EQ(all.narrower, 1);
}

TEST(CalibrationStudy, KnowsWhichRowsThereAre) {
  EXPECT_EQ(all_condition_numbers().size(), 20U);
  EXPECT_THROW(study_calibration({0}, few_runs()), std::invalid_argument);
  EXPECT_THROW(study_calibration({21}, few_runs()), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
