// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A motion and 30 observations without ids on a fixed map of 1000 landmarks, and a motion and a
// scan with 60 landmarks in the state; association included.
#include <benchmark/benchmark.h>

#include "falko_slam/localization/landmark_filter.hpp"
#include "localization/landmark_drive.hpp"

namespace falko_slam {
namespace {

struct Scene {
  std::shared_ptr<const LandmarkIndex> map;
  PoseEstimate start{{}, pose_covariance(0.05, 0.01)};
  PoseEstimate motion;
  std::vector<LandmarkObservation> observations;
};

// `strangers` of the 30 observations are of nothing on the map, but near one of its landmarks.
Scene scene_of(ObservationModel model, std::size_t strangers) {
  std::mt19937_64 random = test::seeded_random();
  Scene scene;
  const auto landmarks = test::scattered_landmarks(1000, 150.0, 1.0, 0.005, random);
  scene.map = std::make_shared<LandmarkIndex>(landmarks);
  scene.motion = tricycle_motion({}, 400.0, {0.1, 0.12}, {});
  const Pose2 truth = test::disturbed(scene.start, random) * scene.motion.pose;
  const Eigen::Matrix2d noise = model == ObservationModel::kCartesian ? test::diagonal(0.01, 0.01)
                                                                      : test::diagonal(0.01, 0.002);
  for (const Landmark& landmark : landmarks) {
    const double range = (landmark.position - truth.translation()).norm();
    if (range < 0.5 || range > 20.0 || scene.observations.size() == 30) continue;
    auto observation = test::seen(model, truth, {}, landmark.position, noise);
    if (scene.observations.size() < strangers) observation.value.x() += 0.15;
    scene.observations.push_back(test::noisy(observation, random));
  }
  return scene;
}

void predict_and_update(benchmark::State& state, ObservationModel model) {
  const Scene scene = scene_of(model, static_cast<std::size_t>(state.range(0)));
  PoseFilter filter({}, scene.map, scene.start);
  std::size_t pairs = 0;
  for (auto _ : state) {
    filter.reset(scene.start);
    filter.predict(scene.motion);
    pairs = filter.update(scene.observations).association.pairs.size();
  }
  state.counters["observations"] = static_cast<double>(scene.observations.size());
  state.counters["pairs"] = static_cast<double>(pairs);
}

BENCHMARK_CAPTURE(predict_and_update, cartesian, ObservationModel::kCartesian)
    ->Arg(0)
    ->Arg(3)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(predict_and_update, range_bearing, ObservationModel::kRangeBearing)
    ->Arg(0)
    ->Arg(3)
    ->Unit(benchmark::kMicrosecond);

// All 60 landmarks are in the state; so many of them are seen in every scan.
void step_with_60_landmarks(benchmark::State& state) {
  std::mt19937_64 random = test::seeded_random();
  const auto landmarks = test::scattered_landmarks(60, 20.0, 1.0, 0.0, random);
  const Eigen::Matrix2d noise = test::diagonal(0.01, 0.01);
  const PoseEstimate motion{{}, pose_covariance(1e-3, 1e-4)};
  LandmarkFilterParams params;
  params.hits = 1;
  params.forget_after = 1000.0;
  LandmarkFilter filter(params, {{}, pose_covariance(0.01, 0.001)});
  FeatureObservations scan;
  for (const Landmark& landmark : landmarks) {
    scan.points.push_back(
        test::seen(ObservationModel::kCartesian, {}, {}, landmark.position, noise));
  }
  filter.update({}, scan);
  scan.points.resize(static_cast<std::size_t>(state.range(0)));
  std::vector<FeatureObservations> scans(50, scan);
  for (auto& each : scans) {
    for (auto& point : each.points) point = test::noisy(point, random);
  }
  std::size_t number = 0;
  int degrees = 0;
  for (auto _ : state) {
    filter.predict(motion);
    degrees = filter.update({}, scans[number++ % scans.size()]).degrees_of_freedom;
  }
  state.counters["landmarks"] = static_cast<double>(filter.landmarks().size());
  state.counters["pairs"] = 0.5 * degrees;
}

BENCHMARK(step_with_60_landmarks)->Arg(20)->Arg(30)->Arg(60)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace falko_slam

BENCHMARK_MAIN();
