// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "localization/landmark_drive.hpp"

namespace falko_slam {
namespace {

using Model = ObservationModel;

std::shared_ptr<const LandmarkIndex> hall(std::size_t count, double size, double deviation) {
  std::mt19937_64 random = test::seeded_random();
  return std::make_shared<LandmarkIndex>(
      test::scattered_landmarks(count, size, 1.5, deviation, random));
}

double smallest_eigenvalue(const Eigen::Matrix3d& covariance) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues()[0];
}

TEST(TricycleMotion, IsThatOfTheThesisWithTheNoiseOfAnArc) {
  const TricycleParams tricycle;
  const OdometryNoise noise;
  const auto motion = tricycle_motion(tricycle, 400.0, {0.2, 0.3}, noise);
  const Pose2 expected = drive_rk2(tricycle, 400.0, {0.2, 0.3});
  EXPECT_EQ(difference(motion.pose, expected).norm(), 0.0);
  EXPECT_EQ(motion.covariance, arc_covariance(tricycle, 400.0, 0.25, noise));
}

// (5.13) is the derivative of (5.8): compose() by the motion's left side.
TEST(PoseFilter, PredictsByTheJacobianOfNumericDifferentiation) {
  const PoseEstimate motion = tricycle_motion({}, 400.0, {0.2, 0.3}, {});
  PoseEstimate start{{1.0, 2.0, 2.5}, Eigen::Matrix3d::Zero()};
  start.covariance = Eigen::Vector3d(0.01, 0.04, 0.0009).asDiagonal();
  start.covariance(0, 2) = start.covariance(2, 0) = 0.002;
  PoseFilter filter({}, hall(3, 20.0, 0.01), start);
  ASSERT_TRUE(filter.predict(motion));

  const double step = 1e-6;
  Eigen::Matrix3d G, V;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d by = step * Eigen::Vector3d::Unit(i);
    const Pose2& q = start.pose;
    const Pose2& u = motion.pose;
    const Pose2 moved(q.x() + by.x(), q.y() + by.y(), q.theta() + by.z());
    const Pose2 further(u.x() + by.x(), u.y() + by.y(), u.theta() + by.z());
    G.col(i) = difference(moved * u, q * u) / step;
    V.col(i) = difference(q * further, q * u) / step;
  }
  const Eigen::Matrix3d expected =
      G * start.covariance * G.transpose() + V * motion.covariance * V.transpose();
  EXPECT_LT((filter.map_T_base().covariance - expected).norm(), 1e-8);
}

TEST(Correct, OneByOneIsAllAtOnce) {
  std::mt19937_64 random = test::seeded_random();
  const auto map = hall(20, 20.0, 0.01);
  PoseEstimate estimate{{1.0, -2.0, 3.1}, pose_covariance(0.1, 0.03)};
  const Pose2 truth = test::disturbed(estimate, random);
  std::vector<LandmarkObservation> observations;
  for (std::uint32_t i = 0; i < 10; ++i) {
    observations.push_back(
        test::noisy(test::seen(Model::kRangeBearing, truth, test::kLaserMount,
                               map->landmarks()[i].position, test::diagonal(0.02, 0.003)),
                    random));
    observations.back().id = i;
  }
  const auto pairs = gate_pairs(estimate, test::kLaserMount, *map, observations, {}).pairs;
  ASSERT_GT(pairs.size(), 8U);

  const auto n = static_cast<Eigen::Index>(2 * pairs.size());
  Eigen::MatrixXd H(n, 3), N = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd innovation(n);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    H.middleRows<2>(row) = pairs[i].dobservation_dpose;
    N.block<2, 2>(row, row) = pairs[i].noise;
    innovation.segment<2>(row) = pairs[i].innovation;
  }
  // The least squares of prior and observations, (5.5) to (5.7) in information form.
  const Eigen::Matrix3d information =
      estimate.covariance.inverse() + H.transpose() * N.inverse() * H;
  const Eigen::Vector3d step = information.ldlt().solve(H.transpose() * N.inverse() * innovation);

  const PoseCorrection corrected = correct(estimate, pairs);
  const Eigen::Vector3d moved = difference(corrected.map_T_base.pose, estimate.pose);
  EXPECT_LT((moved - step).norm(), 1e-12);
  EXPECT_LT((corrected.map_T_base.covariance - information.inverse()).norm(), 1e-12);
}

// Without turning, with the heading known, all is linear: the filter is least squares over all.
TEST(PoseFilter, IsBatchLeastSquaresWhereAllIsLinear) {
  std::mt19937_64 random = test::seeded_random();
  const auto map = hall(10, 20.0, 0.0);
  const PoseEstimate start{{0.0, 0.0, 0.0}, pose_covariance(0.5, 0.0)};
  PoseFilter filter({}, map, start);
  const PoseEstimate motion{{0.3, 0.0, 0.0}, pose_covariance(0.02, 0.0)};
  const Eigen::Matrix2d noise = test::diagonal(0.05, 0.05);

  // One axis after the other: x_0 from the prior, x_k - x_(k-1) from motions, x_k from landmarks.
  constexpr int kSteps = 12;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(kSteps + 1, kSteps + 1);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(kSteps + 1, 2);
  A(0, 0) += 1.0 / 0.25;
  for (int k = 1; k <= kSteps; ++k) {
    const double weight = 1.0 / (0.02 * 0.02);
    A(k, k) += weight;
    A(k - 1, k - 1) += weight;
    A(k, k - 1) -= weight;
    A(k - 1, k) -= weight;
    b(k, 0) += weight * 0.3;
    b(k - 1, 0) -= weight * 0.3;
    ASSERT_TRUE(filter.predict(motion));
    std::vector<LandmarkObservation> observations;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto& position = map->landmarks()[i].position;
      observations.push_back(test::noisy(
          test::seen(Model::kCartesian, {0.3 * k + 0.1, 0.05, 0.0}, {}, position, noise), random));
      observations.back().id = i;
      A(k, k) += 1.0 / 0.0025;
      b.row(k) += (position - observations.back().value).transpose() / 0.0025;
    }
    ASSERT_EQ(filter.update(observations).degrees_of_freedom, 8);
  }
  const Eigen::MatrixXd solution = A.ldlt().solve(b);
  EXPECT_NEAR(filter.map_T_base().pose.x(), solution(kSteps, 0), 1e-10);
  EXPECT_NEAR(filter.map_T_base().pose.y(), solution(kSteps, 1), 1e-10);
  EXPECT_NEAR(filter.map_T_base().covariance(0, 0), A.inverse()(kSteps, kSteps), 1e-12);
}

TEST(PoseFilter, KeepsItsCovarianceSymmetricAndPositive) {
  std::mt19937_64 random = test::seeded_random();
  const auto map = hall(40, 20.0, 0.0);
  PoseFilter filter({test::kLaserMount, {}}, map, {{}, pose_covariance(10.0, 0.2)});
  Pose2 truth;
  for (int step = 0; step < 3000; ++step) {
    const PoseEstimate motion{{0.02, 0.0, 0.01}, pose_covariance(1e-6, 1e-7)};
    truth = truth * motion.pose;
    ASSERT_TRUE(filter.predict(motion));
    std::vector<LandmarkObservation> observations;
    for (std::uint32_t i = 0; i < 10; ++i) {
      observations.push_back(
          test::noisy(test::seen(Model::kRangeBearing, truth, test::kLaserMount,
                                 map->landmarks()[i].position, test::diagonal(1e-4, 1e-5)),
                      random));
      observations.back().id = i;
    }
    filter.update(observations);
    const Eigen::Matrix3d& P = filter.map_T_base().covariance;
    ASSERT_EQ(P, P.transpose());
    ASSERT_GT(smallest_eigenvalue(P), 0.0);
  }
}

TEST(PoseFilter, LetsNothingInThatIsNotFinite) {
  const auto map = hall(10, 20.0, 0.01);
  PoseFilter filter({}, map, {{1.0, 2.0, 3.0}, pose_covariance(0.1, 0.1)});
  const Eigen::Matrix3d before = filter.map_T_base().covariance;

  PoseEstimate motion{{std::nan(""), 0.0, 0.0}, pose_covariance(0.1, 0.1)};
  EXPECT_FALSE(filter.predict(motion));
  motion = {{0.1, 0.0, 0.0}, -pose_covariance(0.1, 0.1)};
  EXPECT_FALSE(filter.predict(motion));
  motion.covariance = pose_covariance(HUGE_VAL, 0.1);
  EXPECT_FALSE(filter.predict(motion));
  LandmarkObservation observation;
  observation.value = {HUGE_VAL, 0.0};
  observation.covariance = test::diagonal(0.1, 0.1);
  const PoseUpdate update = filter.update({observation});
  EXPECT_FALSE(update.corrected());
  EXPECT_EQ(update.association.verdicts[0], ObservationVerdict::kInvalid);

  EXPECT_EQ(filter.map_T_base().pose.x(), 1.0);
  EXPECT_EQ(filter.map_T_base().covariance, before);
}

TEST(PoseFilter, WrapsTheHeading) {
  const auto map = hall(10, 20.0, 0.0);
  PoseFilter filter({}, map, {{0.0, 0.0, kPi - 0.01}, pose_covariance(0.1, 0.1)});
  std::vector<LandmarkObservation> observations;
  for (std::uint32_t i = 0; i < 10; ++i) {
    observations.push_back(test::seen(Model::kRangeBearing, {0.0, 0.0, -kPi + 0.02}, {},
                                      map->landmarks()[i].position, test::diagonal(0.01, 0.001)));
    observations.back().id = i;
  }
  EXPECT_TRUE(filter.update(observations).corrected());
  EXPECT_NEAR(filter.map_T_base().pose.theta(), -kPi + 0.02, 1e-3);
}

TEST(PoseFilter, RefusesToBeginFromNonsense) {
  const auto map = hall(3, 20.0, 0.01);
  const PoseEstimate good;
  EXPECT_NO_THROW(PoseFilter({}, map, good));
  EXPECT_THROW(PoseFilter({}, nullptr, good), std::invalid_argument);
  EXPECT_THROW(PoseFilter({}, map, {{std::nan(""), 0, 0}, good.covariance}), std::invalid_argument);
  EXPECT_THROW(PoseFilter({}, map, {{}, -pose_covariance(1, 1)}), std::invalid_argument);
  EXPECT_THROW(PoseFilter({{0, HUGE_VAL, 0}, {}}, map, good), std::invalid_argument);
}

}  // namespace
}  // namespace falko_slam
