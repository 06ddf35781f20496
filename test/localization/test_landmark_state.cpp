// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_state.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "localization/landmark_drive.hpp"
#include "state_joint_distance.hpp"

namespace falko_slam {
namespace {

Eigen::Matrix2d random_matrix(std::mt19937_64& random) {
  Eigen::Matrix2d matrix;
  for (int i = 0; i < 4; ++i) matrix(i / 2, i % 2) = test::normal(random, 1.0);
  return matrix;
}

Eigen::Matrix<double, 2, 3> random_slopes(std::mt19937_64& random) {
  Eigen::Matrix<double, 2, 3> matrix;
  for (int i = 0; i < 6; ++i) matrix(i / 3, i % 3) = test::normal(random, 1.0);
  return matrix;
}

Eigen::Matrix2d random_noise(std::mt19937_64& random) {
  const Eigen::Matrix2d A = random_matrix(random);
  return A * A.transpose() + 0.1 * Eigen::Matrix2d::Identity();
}

LandmarkState random_state(std::mt19937_64& random, int landmarks) {
  LandmarkState state({{1.0, 2.0, 0.5}, pose_covariance(0.4, 0.2)}, landmarks + 2);
  for (int i = 0; i < landmarks; ++i) {
    state.add(Eigen::Vector2d(i, -i), random_slopes(random), random_noise(random));
    state.predict({{0.1, 0.02, 0.3}, pose_covariance(0.1, 0.05)});
  }
  return state;
}

std::vector<LandmarkState::Row> random_rows(std::mt19937_64& random, int count) {
  std::vector<LandmarkState::Row> rows;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d innovation(test::normal(random, 0.5), test::normal(random, 0.5));
    rows.push_back({count - 1 - i, random_slopes(random), random_matrix(random), innovation,
                    random_noise(random)});
  }
  return rows;
}

struct Dense {
  Eigen::MatrixXd H, N;
  Eigen::VectorXd innovation;
};

Dense dense(const LandmarkState& state, const std::vector<LandmarkState::Row>& rows) {
  const int m = 2 * static_cast<int>(rows.size());
  Dense all{Eigen::MatrixXd::Zero(m, state.size()), Eigen::MatrixXd::Zero(m, m),
            Eigen::VectorXd(m)};
  for (int i = 0; i < m; i += 2) {
    const auto& row = rows[static_cast<std::size_t>(i / 2)];
    all.H.block<2, 3>(i, 0) = row.dpose;
    all.H.block<2, 2>(i, 3 + 2 * row.landmark) = row.dlandmark;
    all.N.block<2, 2>(i, i) = row.noise;
    all.innovation.segment<2>(i) = row.innovation;
  }
  return all;
}

TEST(LandmarkState, CorrectsAsTheWholeMatricesInJosephsForm) {
  std::mt19937_64 random = test::seeded_random();
  for (int run = 0; run < 20; ++run) {
    LandmarkState state = random_state(random, 6);
    const auto rows = random_rows(random, 5);
    const auto [H, N, innovation] = dense(state, rows);
    const Eigen::MatrixXd P = state.covariance();
    const Eigen::MatrixXd S = H * P * H.transpose() + N;
    const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
    const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(15, 15) - K * H;
    const Eigen::MatrixXd expected = rest * P * rest.transpose() + K * N * K.transpose();
    const Eigen::VectorXd step = K * innovation;
    const PoseEstimate before = state.pose();
    const Eigen::Vector2d third = state.mean_of(2);

    const double nis = state.correct(rows);

    EXPECT_NEAR(nis, innovation.dot(S.inverse() * innovation), 1e-9);
    EXPECT_LT((state.covariance() - expected).norm(), 1e-10);
    EXPECT_LT((difference(state.pose().pose, before.pose) - step.head<3>()).norm(), 1e-9);
    EXPECT_LT((state.mean_of(2) - third - step.segment<2>(7)).norm(), 1e-10);
  }
}

// Of a pose of which nothing is known to one of a millimetre: with 16 digits there is nothing left
// of the difference beyond some variance. Compared with the information form.
TEST(LandmarkState, CorrectsAVaguePoseOrLeavesItAsItWas) {
  std::vector<LandmarkState::Row> rows;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 20; ++i) {  // points around, as a laser at the origin sees them
    LandmarkState::Row row;
    row.dpose << -1.0, 0.0, 10.0 * std::sin(i), 0.0, -1.0, -10.0 * std::cos(i);
    row.innovation = {0.3, -0.2};
    row.noise = 1e-5 * Eigen::Matrix2d::Identity();
    information += 1e5 * row.dpose.transpose() * row.dpose;
    rows.push_back(row);
  }
  for (double variance = 1.0; variance < 1e300; variance *= 10.0) {
    const Eigen::Matrix3d before = Eigen::Vector3d(variance, variance, 1.0).asDiagonal();
    LandmarkState state({{1.0, 2.0, 0.5}, before}, 5);
    const double nis = state.correct(rows);
    if (nis < 0.0) {
      EXPECT_GT(variance, 1e7);
      EXPECT_EQ(state.pose().covariance, before);
      EXPECT_EQ(state.pose().pose.x(), 1.0);
      continue;
    }
    Eigen::Matrix3d all = information;
    all.diagonal() += before.diagonal().cwiseInverse();
    const Eigen::Array3d expected = all.inverse().diagonal();
    const Eigen::Array3d found = state.pose().covariance.diagonal();
    EXPECT_LT((found / expected - 1.0).abs().maxCoeff(), 0.01) << "variance " << variance;
  }
}

TEST(LandmarkState, PredictsThePoseAndWhatHangsOnIt) {
  std::mt19937_64 random = test::seeded_random();
  LandmarkState state = random_state(random, 3);
  const PoseEstimate motion{{0.4, -0.1, 0.2}, pose_covariance(0.1, 0.02)};
  const auto [left, right] = compose_jacobians(state.pose().pose, motion.pose);
  Eigen::MatrixXd F = Eigen::MatrixXd::Identity(9, 9), Q = Eigen::MatrixXd::Zero(9, 9);
  F.topLeftCorner<3, 3>() = left;
  Q.topLeftCorner<3, 3>() = right * motion.covariance * right.transpose();
  const Eigen::MatrixXd expected = F * state.covariance() * F.transpose() + Q;
  state.predict(motion);
  EXPECT_LT((state.covariance() - expected).norm(), 1e-12);
}

TEST(LandmarkState, RemovingIsMarginalising) {
  std::mt19937_64 random = test::seeded_random();
  for (int gone = 0; gone < 4; ++gone) {
    LandmarkState state = random_state(random, 4);
    const Eigen::MatrixXd P = state.covariance();
    std::vector<int> kept = {0, 1, 2};
    for (int i = 0; i < 3; ++i) {
      const int from = i == gone ? 3 : i;  // the last one takes its place
      kept.push_back(3 + 2 * from);
      kept.push_back(4 + 2 * from);
    }
    state.remove(gone);
    for (int i = 0; i < 9; ++i) {
      for (int j = 0; j < 9; ++j) {
        EXPECT_EQ(state.covariance()(i, j),
                  P(kept[static_cast<std::size_t>(i)], kept[static_cast<std::size_t>(j)]));
      }
    }
  }
}

TEST(StateJointDistance, IsThatOfTheWholeMatrixInWhateverOrder) {
  std::mt19937_64 random = test::seeded_random();
  const LandmarkState state = random_state(random, 6);
  const auto rows = random_rows(random, 6);
  StateJointDistance distance(state, rows, 6);
  for (const std::vector<std::size_t>& order :
       {std::vector<std::size_t>{0, 1, 2, 3, 4, 5}, {5, 3, 0}, {5, 1, 4, 2}}) {
    std::vector<LandmarkState::Row> chosen;
    for (std::size_t i = 0; i < order.size(); ++i) {
      chosen.push_back(rows[order[i]]);
      const auto [H, N, innovation] = dense(state, chosen);
      const Eigen::MatrixXd S = H * state.covariance() * H.transpose() + N;
      EXPECT_NEAR(distance.with(i, order[i]), innovation.dot(S.inverse() * innovation), 1e-9);
    }
  }
}

}  // namespace
}  // namespace falko_slam
