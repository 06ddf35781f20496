// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/mrclam_evaluation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/measurement_model.hpp"
#include "support/recordings.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace {

// On a circle among four landmarks; noise as the filter is told, new each time.
MrclamRun simulated_run() {
  std::mt19937_64 random = test::seeded_random();
  const MrclamParams params;
  MrclamRun run;
  const Eigen::Vector2d corners[] = {{3, 3}, {-3, 3}, {-3, -3}, {3, -3}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    run.landmarks.push_back({i + 6, {corners[i], Eigen::Matrix2d::Zero()}});
  }
  const double period = 0.1;
  Pose2 truth(0.5, 0.0, 0.0);
  for (int i = 0; i < 6000; ++i) {
    const Time stamp(from_seconds(period * i));
    run.truth.push_back({stamp, truth});
    run.odometry.push_back({stamp, 0.1, 0.2});
    const double way = 0.1 * period, turn = 0.2 * period;
    const double about = params.turn_noise * params.turn_noise * turn +
                         params.heading_drift * params.heading_drift * period;
    const double along = test::normal(random, params.way_noise * std::sqrt(way));
    const double across = test::normal(random, params.way_noise * std::sqrt(way));
    const Pose2 step = Pose2::exp({way, 0.0, turn});
    truth = truth * Pose2(step.x() + along, step.y() + across,
                          step.theta() + test::normal(random, std::sqrt(about)));
    if (i % 5 != 0) continue;
    const auto& landmark = run.landmarks[static_cast<std::size_t>(i / 5 % 4)];
    const auto seen =
        predict_observation(ObservationModel::kRangeBearing, truth, {}, landmark.position.point);
    run.measurements.push_back({stamp + from_seconds(period), landmark.number,
                                seen.value.x() + test::normal(random, params.range_noise),
                                seen.value.y() + test::normal(random, params.bearing_noise)});
  }
  return run;
}

TEST(MrclamEvaluation, IsConsistentWhereNoiseIsWhatItIsTold) {
  const MrclamEvaluation evaluation = evaluate_mrclam(simulated_run(), {});
  EXPECT_LT(evaluation.filter.position, 0.1);
  EXPECT_GT(evaluation.odometry.position, 2.0 * evaluation.filter.position);
  EXPECT_GT(evaluation.used, evaluation.observations * 98 / 100);
  EXPECT_NEAR(evaluation.mean_nis, 1.0, 0.1);
  EXPECT_NEAR(evaluation.nis_inside, 0.95, 0.03);
  EXPECT_NEAR(evaluation.mean_nees, 1.0, 0.2);
}

TEST(MrclamEvaluation, CountsForLessWhatIsCorrelated) {
  MrclamParams params;
  params.correlation_time = 10.0;
  EXPECT_LT(evaluate_mrclam(simulated_run(), params).mean_nis, 0.7);
}

TEST(MrclamEvaluation, RefusesRunsWithoutABeginning) {
  EXPECT_THROW(evaluate_mrclam({}, {}), std::runtime_error);
  MrclamRun run = simulated_run();
  run.truth.clear();
  EXPECT_THROW(evaluate_mrclam(run, {}), std::runtime_error);
  MrclamParams params;
  params.range_noise = 0.0;
  EXPECT_THROW(evaluate_mrclam(simulated_run(), params), std::invalid_argument);
}

class RecordedMrclam : public ::testing::TestWithParam<int> {};

// The robots turn about 0.61 as fast as they are told, so the filter has to be told.
TEST_P(RecordedMrclam, IsFollowedWithAndWithoutBarcodes) {
  const std::string folder = test::mrclam_folder();
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << folder << " is not there: set FALKO_SLAM_DATA to the folder that holds "
                 << "landmarks/mrclam9";
  }
  const MrclamRun run = read_mrclam(folder, GetParam());
  MrclamParams params;
  params.turn_scale = 0.61;
  for (const bool ids : {true, false}) {
    params.use_ids = ids;
    const MrclamEvaluation evaluation = evaluate_mrclam(run, params);
    EXPECT_LT(evaluation.filter.position, 0.2);
    EXPECT_LT(evaluation.median_heading, degrees_to_radians(2.0));
    EXPECT_EQ(evaluation.wrong, 0U);
    EXPECT_GT(evaluation.used, evaluation.observations * 95 / 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RecordedMrclam, ::testing::Values(1, 3));

}  // namespace
}  // namespace falko_slam
