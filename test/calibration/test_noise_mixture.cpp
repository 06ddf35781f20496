// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "noise_mixture.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "calibration/arc_drives.hpp"
#include "falko_slam/calibration/calibration_noise.hpp"
#include "falko_slam/calibration/monte_carlo.hpp"

namespace falko_slam {
namespace {

struct Problem {
  StretchSet set;
  FreeParameters free;
  VehicleCalibration at = test::cb16();
};

Problem simulated_problem() {
  Problem problem;
  auto random = test::seeded_random();
  for (const PathSegment& segment :
       simulate_calibration_drive(thesis_conditions()[0], MonteCarloParams(), random)) {
    problem.set.stretches.push_back(stretch_of(segment));
    problem.set.phases.push_back(static_cast<std::size_t>(phase_of(segment)));
    problem.set.used.push_back(true);
  }
  problem.free = free_parameters({}, problem.at);
  return problem;
}

// Generalised least squares with the whole covariance written out.
TEST(NoiseMixture, IsGeneralisedLeastSquares) {
  Problem problem = simulated_problem();
  for (std::size_t k = 0; k < 5; ++k) {  // the others share nothing
    problem.set.stretches[k].covariance_with_next =
        -0.3 * problem.set.stretches[k].covariance +
        1e-7 * Eigen::Vector3d(2.0, 1.0, 0.1) * Eigen::RowVector3d(1.0, -1.0, 0.1);
  }
  CalibrationNoise noise;
  noise.common_slip = 1e-3;
  noise.common_steer = 5e-4;
  noise.common_position = 2e-3;
  noise.common_turn = 1e-4;
  const auto count = static_cast<Eigen::Index>(problem.set.stretches.size());
  Eigen::MatrixXd V = Eigen::MatrixXd::Zero(3 * count, 3 * count), H(3 * count, 6);
  Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(3 * count, 8);
  Eigen::VectorXd r(3 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const MeasuredStretch& stretch = problem.set.stretches[static_cast<std::size_t>(k)];
    const StretchPrediction prediction = predict(problem.at, stretch.arcs);
    const auto phase = static_cast<Eigen::Index>(problem.set.phases[static_cast<std::size_t>(k)]);
    V.block<3, 3>(3 * k, 3 * k) = residual_covariance(stretch, prediction, noise);
    if (k + 1 < count) {
      V.block<3, 3>(3 * k, 3 * k + 3) = stretch.covariance_with_next;
      V.block<3, 3>(3 * k + 3, 3 * k) = stretch.covariance_with_next.transpose();
    }
    H.middleRows<3>(3 * k) = prediction.dparameters * problem.free.columns;
    Z.block<3, 1>(3 * k, phase) = noise.common_slip * prediction.dslip;
    Z.block<3, 1>(3 * k, phase + 4) = noise.common_steer * prediction.dsteer;
    r.segment<3>(3 * k) = stretch.motion - prediction.motion;
  }
  V += Z * Z.transpose();
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b) {
      if (problem.set.phases[static_cast<std::size_t>(a)] !=
          problem.set.phases[static_cast<std::size_t>(b)]) {
        continue;
      }
      V.block<3, 3>(3 * a, 3 * b) += pose_covariance(noise.common_position, noise.common_turn);
    }
  }
  const Eigen::MatrixXd weight = V.inverse();
  const Eigen::MatrixXd covariance = (H.transpose() * weight * H).inverse();
  const Eigen::VectorXd x = covariance * H.transpose() * weight * r;

  const MixtureComponent found = estimate_with(problem.set, problem.free, problem.at, noise);

  EXPECT_LT((found.covariance - covariance).norm(), 1e-6 * covariance.norm());
  EXPECT_LT((found.correction - x).norm(), 1e-6 * x.norm());
  EXPECT_NEAR(found.chi2, (r - H * x).dot(weight * (r - H * x)), 1e-6);
}

TEST(NoiseMixture, SharesNothingAcrossAStretchThatIsLeftOut) {
  Problem with = simulated_problem();
  for (MeasuredStretch& stretch : with.set.stretches) {
    stretch.covariance_with_next = -0.3 * stretch.covariance;
  }
  with.set.used[2] = false;
  Problem without = with;
  without.set.stretches[1].covariance_with_next.setZero();
  without.set.stretches.erase(without.set.stretches.begin() + 2);
  without.set.phases.erase(without.set.phases.begin() + 2);
  without.set.used.erase(without.set.used.begin() + 2);
  const MixtureComponent left_out = estimate_with(with.set, with.free, with.at, {});
  const MixtureComponent missing = estimate_with(without.set, without.free, without.at, {});
  EXPECT_LT((left_out.correction - missing.correction).norm(), 1e-12);
  EXPECT_NEAR(left_out.chi2, missing.chi2, 1e-9 * missing.chi2);
}

TEST(NoiseMixture, HasOneComponentWhereTheNoiseIsKnown) {
  const Problem problem = simulated_problem();
  CalibrationNoise noise;
  noise.common_slip = noise.common_steer = 0.0;
  noise.unknown_factor = 1.0;

  const auto mixture = noise_mixture(problem.set, problem.free, problem.at, noise);

  ASSERT_EQ(mixture.size(), 1U);
  EXPECT_EQ(mixture[0].weight, 1.0);
}

TEST(NoiseMixture, WeighsBySumOne) {
  const Problem problem = simulated_problem();
  double sum = 0.0;
  for (const auto& component :
       noise_mixture(problem.set, problem.free, problem.at, CalibrationNoise())) {
    sum += component.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(MixtureQuantile, IsThatOfTheNormalDistributionForOne) {
  EXPECT_NEAR(mixture_quantile({1.0}, {2.0}, {3.0}, 0.975), 2.0 + 3.0 * 1.959963984540054, 1e-9);
  EXPECT_NEAR(mixture_quantile({1.0}, {2.0}, {0.0}, 0.5), 2.0, 1e-12);
}

TEST(MixtureQuantile, LiesBetweenTwo) {
  EXPECT_NEAR(mixture_quantile({0.5, 0.5}, {-1.0, 1.0}, {1.0, 1.0}, 0.5), 0.0, 1e-9);
  EXPECT_NEAR(mixture_quantile({0.9, 0.1}, {0.0, 0.0}, {1.0, 10.0}, 0.5), 0.0, 1e-9);
}

}  // namespace
}  // namespace falko_slam
