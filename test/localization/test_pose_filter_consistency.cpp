// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated drives whose noise is exactly what the filter is told: is it as sure as it may be?
#include <gtest/gtest.h>

#include "falko_slam/common/chi_square.hpp"
#include "localization/landmark_drive.hpp"

namespace falko_slam {
namespace {

using Model = ObservationModel;

constexpr int kRuns = 50;
const Pose2 kFrontLaser(1.4, 0.1, 0.05);

struct Tally {
  double nees = 0.0, nis = 0.0;
  int nees_degrees = 0, nis_degrees = 0;
  std::size_t used = 0, observed = 0, wrong = 0;
};

Eigen::Matrix2d measured_noise(Model model) {
  return model == Model::kCartesian ? test::diagonal(0.008, 0.012) : test::diagonal(0.01, 0.002);
}

// So wide that it does not cut off the tail of what is to be measured.
AssociationParams wide_gates() {
  AssociationParams params;
  params.gate_probability = params.joint_probability = 0.999999;
  return params;
}

// A drive in a hall of 1000 landmarks. Each look at one is off by what its covariance says anew:
// what the filter takes for granted.
class Drive {
 public:
  Drive(Model model, bool ids, std::mt19937_64& random)
      : model_(model), ids_(ids), random_(random) {
    real_ = test::scattered_landmarks(1000, 120.0, 1.0, 0.002, random);
    map_ = std::make_shared<LandmarkIndex>(real_);
  }

  void run(Tally& tally) {
    const PoseEstimate start{{0.0, -20.0, 0.2}, pose_covariance(0.05, 0.01)};
    PoseFilter filter({kFrontLaser, wide_gates()}, map_, start);
    truth_ = test::disturbed(start, random_);
    for (int step = 0; step < 40; ++step) {
      for (int i = 0; i < 5; ++i) drive(filter);
      const auto observations = look();
      const PoseUpdate update = filter.update(observations);
      for (const LandmarkPair& pair : update.association.pairs) {
        if (pair.landmark != seen_[pair.observation]) ++tally.wrong;
      }
      tally.nis += update.nis;
      tally.nis_degrees += update.degrees_of_freedom;
      tally.used += update.association.pairs.size();
      tally.observed += observations.size();
    }
    tally.nees += test::nees(filter.map_T_base(), truth_);
    tally.nees_degrees += 3;
  }

 private:
  void drive(PoseFilter& filter) {
    const PoseEstimate motion = tricycle_motion({}, 100.0, {0.1, 0.12}, {});
    truth_ = truth_ * test::disturbed(motion, random_);
    filter.predict(motion);
  }

  std::vector<LandmarkObservation> look() {
    std::vector<LandmarkObservation> observations;
    seen_.clear();
    for (std::size_t i = 0; i < real_.size() && observations.size() < 20; ++i) {
      const double range = (real_[i].position - truth_ * kFrontLaser.translation()).norm();
      if (range < 1.0 || range > 15.0) continue;
      const Eigen::Vector2d position =
          real_[i].position + test::drawn<2>(real_[i].covariance, random_);
      observations.push_back(test::noisy(
          test::seen(model_, truth_, kFrontLaser, position, measured_noise(model_)), random_));
      if (ids_) observations.back().id = real_[i].id;
      seen_.push_back(i);
    }
    return observations;
  }

  Model model_;
  bool ids_;
  std::mt19937_64& random_;
  std::vector<Landmark> real_;
  std::shared_ptr<const LandmarkIndex> map_;
  Pose2 truth_;
  std::vector<std::size_t> seen_;
};

void expect_consistent(double sum, int degrees, const char* what) {
  EXPECT_GT(sum, chi_square_bound(0.975, degrees)) << what << " / " << degrees;
  EXPECT_LT(sum, chi_square_bound(0.025, degrees)) << what << " / " << degrees;
}

Tally runs_of(Model model, bool ids) {
  std::mt19937_64 random = test::seeded_random();
  Tally tally;
  for (int run = 0; run < kRuns; ++run) Drive(model, ids, random).run(tally);
  return tally;
}

class PoseFilterConsistency : public ::testing::TestWithParam<std::pair<Model, bool>> {};

TEST_P(PoseFilterConsistency, NeesAndNisLieInTheirBounds) {
  const Tally tally = runs_of(GetParam().first, GetParam().second);
  EXPECT_EQ(tally.wrong, 0U);
  EXPECT_GT(tally.used, tally.observed * 98 / 100);
  expect_consistent(tally.nees, tally.nees_degrees, "NEES");
  expect_consistent(tally.nis, tally.nis_degrees, "NIS");
}

INSTANTIATE_TEST_SUITE_P(Models, PoseFilterConsistency,
                         ::testing::Values(std::pair(Model::kCartesian, false),
                                           std::pair(Model::kCartesian, true),
                                           std::pair(Model::kRangeBearing, false),
                                           std::pair(Model::kRangeBearing, true)));

}  // namespace
}  // namespace falko_slam
