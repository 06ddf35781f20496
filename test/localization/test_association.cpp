// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/association.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <set>
#include <stdexcept>

#include "falko_slam/localization/pose_filter.hpp"
#include "localization/landmark_drive.hpp"

namespace falko_slam {
namespace {

using Model = ObservationModel;

const Eigen::Matrix2d kPointNoise = test::diagonal(0.01, 0.01);

Eigen::Matrix2d noise_of(Model model) {
  return model == Model::kCartesian ? kPointNoise : test::diagonal(0.01, 0.002);
}

PoseEstimate estimate_at(const Pose2& pose, double distance, double turn) {
  return {pose, pose_covariance(distance, turn)};
}

// nu^T (H P H^T + N)^-1 nu of all pairs, by the whole matrix.
double joint_distance(const PoseEstimate& estimate, const std::vector<LandmarkPair>& pairs) {
  const auto n = static_cast<Eigen::Index>(2 * pairs.size());
  Eigen::MatrixXd H(n, 3), S = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd innovation(n);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    H.middleRows<2>(row) = pairs[i].dobservation_dpose;
    S.block<2, 2>(row, row) = pairs[i].noise;
    innovation.segment<2>(row) = pairs[i].innovation;
  }
  S += H * estimate.covariance * H.transpose();
  return innovation.dot(S.ldlt().solve(innovation));
}

std::set<std::pair<std::size_t, std::size_t>> numbers(const std::vector<LandmarkPair>& pairs) {
  std::set<std::pair<std::size_t, std::size_t>> result;
  for (const LandmarkPair& pair : pairs) result.emplace(pair.observation, pair.landmark);
  return result;
}

// The index by place must not lose a pair that passes its gate.
TEST(GatePairs, FindsWhatTryingEveryLandmarkFinds) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 200; ++run) {
    const LandmarkIndex map(test::scattered_landmarks(200, 40.0, 0.0, 0.05, random));
    const Pose2 truth(test::uniform(random, -10, 10), test::uniform(random, -10, 10),
                      test::uniform(random, -kPi, kPi));
    const PoseEstimate estimate = estimate_at(truth, std::exp(test::uniform(random, -6.0, 1.0)),
                                              std::exp(test::uniform(random, -8.0, 0.5)));
    const Model model = run % 2 == 0 ? Model::kCartesian : Model::kRangeBearing;
    std::vector<LandmarkObservation> observations, known;
    std::set<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t i = 0; i < 5; ++i) {
      const auto& position = map.landmarks()[7 * i].position;
      observations.push_back(test::noisy(
          test::seen(model, truth, test::kLaserMount, position, noise_of(model)), random));
      for (const Landmark& landmark : map.landmarks()) {
        known.assign(1, observations.back());
        known.front().id = landmark.id;
        const auto alone = gate_pairs(estimate, test::kLaserMount, map, known, {});
        for (const LandmarkPair& pair : alone.pairs) expected.emplace(i, pair.landmark);
      }
    }
    EXPECT_EQ(numbers(gate_pairs(estimate, test::kLaserMount, map, observations, {}).pairs),
              expected);
  }
}

struct Scene {
  LandmarkIndex map;
  Pose2 truth;
  PoseEstimate estimate;
  std::vector<LandmarkObservation> observations;  // of landmark 0, 1, 2, ...
};

Scene random_scene(std::mt19937_64& random, std::size_t seen, double apart, Model model) {
  LandmarkIndex map(test::scattered_landmarks(40, 30.0, apart, 0.003, random));
  Scene scene{map, {}, estimate_at({1.0, -2.0, 3.0}, 0.1, 0.02), {}};
  scene.truth = test::disturbed(scene.estimate, random);
  for (std::size_t i = 0; i < seen; ++i) {
    const auto& position = map.landmarks()[i].position;
    scene.observations.push_back(test::noisy(
        test::seen(model, scene.truth, test::kLaserMount, position, noise_of(model)), random));
  }
  return scene;
}

TEST(Associate, HasTheJointDistanceOfTheWholeMatrix) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 50; ++run) {
    const Model model = run % 2 == 0 ? Model::kCartesian : Model::kRangeBearing;
    const Scene scene = random_scene(random, 12, 3.0, model);
    const auto found =
        associate(scene.estimate, test::kLaserMount, scene.map, scene.observations, {});
    const double nis = correct(scene.estimate, found.pairs).nis;
    EXPECT_NEAR(nis, joint_distance(scene.estimate, found.pairs), 1e-6 * (1.0 + nis));
  }
}

TEST(Associate, PairsRightlyWhereLandmarksStandApart) {
  std::mt19937_64 random = test::seeded_random();
  std::size_t pairs = 0, wrong = 0;
  for (int run = 0; run < 100; ++run) {
    const Scene scene = random_scene(random, 15, 2.0, Model::kCartesian);
    for (const LandmarkPair& pair :
         associate(scene.estimate, test::kLaserMount, scene.map, scene.observations, {}).pairs) {
      ++pairs;
      if (pair.landmark != pair.observation) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_GT(pairs, 1450U);  // of 1500; gates let 99.7 % pass
}

// Each alone fits to either landmark of a pair; only together they tell which.
TEST(Associate, TellsApartJointlyWhatFitsAloneToMore) {
  const Eigen::Matrix2d none = Eigen::Matrix2d::Zero();
  const LandmarkIndex map({{0, {5.0, 0.0}, none},
                           {1, {5.0, 0.4}, none},
                           {2, {0.0, 6.0}, none},
                           {3, {-5.0, 1.0}, none}});
  const PoseEstimate estimate = estimate_at({}, 0.3, 1e-3);
  const Pose2 truth(0.0, -0.25, 0.0);
  std::vector<LandmarkObservation> observations;
  for (const std::size_t i : {0U, 2U, 3U}) {
    observations.push_back(
        test::seen(Model::kCartesian, truth, {}, map.landmarks()[i].position, kPointNoise));
  }
  EXPECT_EQ(gate_pairs(estimate, {}, map, observations, {}).pairs.size(), 4U);

  const auto found = associate(estimate, {}, map, observations, {});
  EXPECT_EQ(numbers(found.pairs),
            (std::set<std::pair<std::size_t, std::size_t>>{{0, 0}, {1, 2}, {2, 3}}));
}

TEST(Associate, RefusesWhatCouldBeEither) {
  const Eigen::Matrix2d none = Eigen::Matrix2d::Zero();
  const LandmarkIndex map({{0, {5.0, 0.0}, none}, {1, {5.0, 0.2}, none}, {2, {-5.0, 0.1}, none}});
  const PoseEstimate estimate = estimate_at({}, 0.1, 0.05);
  const std::vector<LandmarkObservation> observations = {
      {Model::kCartesian, {5.0, 0.1}, kPointNoise, std::nullopt},
      {Model::kCartesian, {-5.0, 0.1}, kPointNoise, std::nullopt}};

  const auto found = associate(estimate, {}, map, observations, {});
  EXPECT_EQ(found.verdicts[0], ObservationVerdict::kAmbiguous);
  EXPECT_EQ(found.verdicts[1], ObservationVerdict::kUsed);
  EXPECT_EQ(numbers(found.pairs), (std::set<std::pair<std::size_t, std::size_t>>{{1, 2}}));
}

TEST(Associate, RefusesTwoObservationsOfOneLandmark) {
  const LandmarkIndex map({{0, {5.0, 0.0}, Eigen::Matrix2d::Zero()}});
  const LandmarkObservation observation{Model::kCartesian, {5.0, 0.0}, kPointNoise, std::nullopt};
  const auto found =
      associate(estimate_at({}, 0.01, 0.01), {}, map, {observation, observation}, {});
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_EQ(found.verdicts[0], ObservationVerdict::kAmbiguous);
  EXPECT_EQ(found.verdicts[1], ObservationVerdict::kAmbiguous);
}

// 15 right ones and one that is 0.25 m off: inside its own gate, for the pose may be off by that.
TEST(Associate, RefusesWhatDoesNotFitToTheOthers) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 50; ++run) {
    Scene scene = random_scene(random, 15, 3.0, Model::kCartesian);
    scene.observations[4].value += Eigen::Vector2d(0.15, 0.15);
    const auto found =
        associate(scene.estimate, test::kLaserMount, scene.map, scene.observations, {});
    EXPECT_NE(found.verdicts[4], ObservationVerdict::kUsed);
    EXPECT_GT(found.pairs.size(), 10U);
  }
}

// Many near strangers, few steps: what is cut short must still be the largest set found.
TEST(Associate, FindsTheOthersAmongStrangersWithinFewSteps) {
  std::mt19937_64 random = test::seeded_random();
  AssociationParams params;
  params.max_nodes = 500;
  std::size_t pairs = 0;
  for (int run = 0; run < 50; ++run) {
    Scene scene = random_scene(random, 25, 2.0, Model::kCartesian);
    for (std::size_t i = 0; i < 5; ++i) {
      const double turn = test::uniform(random, -kPi, kPi);
      scene.observations[i].value += 0.15 * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    }
    const auto found =
        associate(scene.estimate, test::kLaserMount, scene.map, scene.observations, params);
    for (const LandmarkPair& pair : found.pairs) EXPECT_GE(pair.observation, 5U) << run;
    pairs += found.pairs.size();
  }
  EXPECT_GT(pairs, 960U);  // of 1000
}

TEST(Associate, SaysWhyAnObservationIsNotUsed) {
  const LandmarkIndex map({{8, {5.0, 0.0}, Eigen::Matrix2d::Zero()}});
  LandmarkObservation good{Model::kCartesian, {5.0, 0.0}, kPointNoise, std::nullopt};
  LandmarkObservation invalid = good, unknown = good, nowhere = good, elsewhere = good;
  invalid.value.x() = std::nan("");
  unknown.id = 9;
  nowhere.value.x() = 9.0;
  elsewhere.value.x() = 9.0;
  elsewhere.id = 8;
  good.id = 8;

  const auto found = associate(estimate_at({}, 0.01, 0.01), {}, map,
                               {invalid, unknown, nowhere, elsewhere, good}, {});
  EXPECT_EQ(found.verdicts, (std::vector<ObservationVerdict>{
                                ObservationVerdict::kInvalid, ObservationVerdict::kUnknownId,
                                ObservationVerdict::kNoLandmark, ObservationVerdict::kNoLandmark,
                                ObservationVerdict::kUsed}));
}

TEST(Associate, ALandmarkOfWhichLittleIsKnownTakesMore) {
  const LandmarkObservation observation{Model::kCartesian, {5.2, 0.0}, kPointNoise, std::nullopt};
  const auto pairs = [&](double deviation) {
    const LandmarkIndex map({{0, {5.0, 0.0}, test::diagonal(deviation, deviation)}});
    return associate(estimate_at({}, 0.01, 1e-3), {}, map, {observation}, {}).pairs.size();
  };
  EXPECT_EQ(pairs(0.0), 0U);
  EXPECT_EQ(pairs(0.2), 1U);
}

TEST(AssociationParams, AreValidatedWithNameAndValue) {
  AssociationParams params;
  EXPECT_NO_THROW(validate(params));
  params.gate_probability = 1.0;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("gate_probability = 1"), std::string::npos);
  }
  params = {};
  params.ambiguity = std::nan("");
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.max_nodes = 0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.joint_probability = 0.4;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
