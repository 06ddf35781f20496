// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_state.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "covariance_check.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

LandmarkState::LandmarkState(const PoseEstimate& pose, int most)
    : most_(most), mean_(3), covariance_(pose.covariance) {
  mean_ << pose.pose.x(), pose.pose.y(), pose.pose.theta();
}

LandmarkState::LandmarkState(const LandmarkState& other)
    : most_(other.most_),
      landmarks_(other.landmarks_),
      mean_(other.mean_.head(other.size())),
      covariance_(other.covariance()) {}

LandmarkState& LandmarkState::operator=(const LandmarkState& other) {
  if (this != &other) *this = LandmarkState(other);
  return *this;
}

void LandmarkState::make_room() {
  const int needed = size() + 2, all = 3 + 2 * most_;
  if (mean_.size() >= needed) return;
  const int room = std::min(all, std::max(needed, 2 * static_cast<int>(mean_.size())));
  mean_.conservativeResize(room);
  covariance_.conservativeResize(room, room);
}

PoseEstimate LandmarkState::pose() const {
  return {{mean_[0], mean_[1], mean_[2]}, covariance_.topLeftCorner<3, 3>()};
}

Eigen::Matrix2d LandmarkState::covariance_of(int landmark) const {
  const int at = 3 + 2 * landmark;
  return covariance_.block<2, 2>(at, at);
}

void LandmarkState::predict(const PoseEstimate& motion) {
  const PoseEstimate before = pose();
  const PoseEstimate after = compose(before, motion);
  const Eigen::Matrix3d G = compose_jacobians(before.pose, motion.pose).dresult_dleft;
  mean_.head<3>() << after.pose.x(), after.pose.y(), after.pose.theta();
  covariance_.topLeftCorner<3, 3>() = 0.5 * (after.covariance + after.covariance.transpose());
  const int rest = 2 * landmarks_;
  covariance_.block(0, 3, 3, rest) = (G * covariance_.block(0, 3, 3, rest)).eval();
  covariance_.block(3, 0, rest, 3) = covariance_.block(0, 3, 3, rest).transpose();
}

void LandmarkState::loosen(int landmark, const Eigen::Vector2d& variances) {
  covariance_.diagonal().segment<2>(3 + 2 * landmark) += variances;
}

void LandmarkState::add(const Eigen::Vector2d& mean,
                        const Eigen::Matrix<double, 2, 3>& dlandmark_dpose,
                        const Eigen::Matrix2d& noise) {
  make_room();
  const int at = size();
  mean_.segment<2>(at) = mean;
  const Eigen::MatrixXd cross = dlandmark_dpose * covariance_.topRows<3>().leftCols(at);
  covariance_.block(at, 0, 2, at) = cross;
  covariance_.block(0, at, at, 2) = cross.transpose();
  const Eigen::Matrix2d own = cross.leftCols<3>() * dlandmark_dpose.transpose() + noise;
  covariance_.block<2, 2>(at, at) = 0.5 * (own + own.transpose());
  ++landmarks_;
}

void LandmarkState::remove(int landmark) {
  const int at = 3 + 2 * landmark, last = size() - 2;
  if (at != last) {
    mean_.segment<2>(at) = mean_.segment<2>(last).eval();
    covariance_.block(at, 0, 2, size()) = covariance_.block(last, 0, 2, size()).eval();
    covariance_.block(0, at, size(), 2) = covariance_.block(0, last, size(), 2).eval();
  }
  --landmarks_;
}

void LandmarkState::covariance_with(const Row& row, Eigen::Ref<Eigen::MatrixXd> result) const {
  const int n = size();
  result.noalias() = covariance_.block(0, 0, n, 3) * row.dpose.transpose();
  if (!row.inside()) return;
  const int at = 3 + 2 * row.landmark, below = n - at;
  result.topRows(at).noalias() +=
      covariance_.block(at, 0, 2, at).transpose() * row.dlandmark.transpose();
  result.bottomRows(below).noalias() +=
      covariance_.block(at, at, below, 2) * row.dlandmark.transpose();
}

Eigen::Matrix2d LandmarkState::between(const Row& row,
                                       const Eigen::Ref<const Eigen::MatrixXd>& other) {
  Eigen::Matrix2d result = row.dpose * other.topRows<3>();
  if (row.inside()) result += row.dlandmark * other.middleRows<2>(3 + 2 * row.landmark);
  return result;
}

Eigen::Matrix2d LandmarkState::innovation_covariance(const Row& row) const {
  Eigen::Matrix2d known =
      row.dpose * covariance_.topLeftCorner<3, 3>() * row.dpose.transpose() + row.noise;
  if (!row.inside()) return known;
  const int at = 3 + 2 * row.landmark;
  const Eigen::Matrix2d cross =
      row.dpose * covariance_.block<3, 2>(0, at) * row.dlandmark.transpose();
  return known + cross + cross.transpose() +
         row.dlandmark * covariance_of(row.landmark) * row.dlandmark.transpose();
}

double LandmarkState::correct(const std::vector<Row>& rows) {
  const Eigen::MatrixXd before = covariance();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(size());
  const double nis = correct_in_batches(rows, step);
  auto P = covariance_.topLeftCorner(size(), size());
  if (nis < 0.0 || !step.allFinite() || !is_left_of(before)) {
    P = before;
    return -1.0;
  }
  mean_.head(size()) += step;
  mean_[2] = wrap_angle(mean_[2]);
  P.triangularView<Eigen::StrictlyUpper>() = P.transpose();
  return nis;
}

// What is left of a variance that shrinks by more than this is the rounding of the difference.
bool LandmarkState::is_left_of(const Eigen::MatrixXd& before) const {
  constexpr double kLeast = 1e-14;
  return (covariance().diagonal().array() >= kLeast * before.diagonal().array()).all() &&
         is_positive_semidefinite<3>(covariance_.topLeftCorner<3, 3>());
}

// Batch by batch, all from the same point of linearisation: the result is that of all at once, but
// triangular solves stay small.
double LandmarkState::correct_in_batches(const std::vector<Row>& rows, Eigen::VectorXd& step) {
  double nis = 0.0;
  for (std::size_t first = 0; first < rows.size(); first += kBatch) {
    const auto end =
        rows.begin() + static_cast<std::ptrdiff_t>(std::min(first + kBatch, rows.size()));
    const double part =
        correct_batch({rows.begin() + static_cast<std::ptrdiff_t>(first), end}, step);
    if (part < 0.0) return -1.0;
    nis += part;
  }
  return nis;
}

// Keeps up the lower triangle and the blocks on the diagonal only.
double LandmarkState::correct_batch(const std::vector<Row>& rows, Eigen::VectorXd& step) {
  const int n = size(), m = 2 * static_cast<int>(rows.size());
  Eigen::Matrix<double, 2 * kBatch, 2 * kBatch> space;
  if (slopes_.rows() < n) slopes_.resize(n, space.cols());
  auto V = slopes_.topLeftCorner(n, m);
  auto S = space.topLeftCorner(m, m);
  Eigen::VectorXd innovation(m);
  for (int i = 0; i < m; i += 2) {
    const Row& row = rows[static_cast<std::size_t>(i / 2)];
    covariance_with(row, V.middleCols(i, 2));
    for (int j = 0; j <= i; j += 2) {
      S.block<2, 2>(i, j) = between(row, V.middleCols(j, 2));
    }
    S.block<2, 2>(i, i) += row.noise;
    innovation.segment<2>(i) = row.innovation - row.dpose * step.head<3>();
    if (row.inside()) {
      innovation.segment<2>(i) -= row.dlandmark * step.segment<2>(3 + 2 * row.landmark);
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(S);
  if (factor.info() != Eigen::Success) return -1.0;
  const Eigen::VectorXd white = factor.matrixL().solve(innovation);
  factor.matrixU().solveInPlace<Eigen::OnTheRight>(V);
  if (!V.allFinite() || !white.allFinite()) return -1.0;
  step.noalias() += V * white;
  covariance_.topLeftCorner(n, n).selfadjointView<Eigen::Lower>().rankUpdate(V, -1.0);
  covariance_.topLeftCorner<3, 3>().triangularView<Eigen::StrictlyUpper>() =
      covariance_.topLeftCorner<3, 3>().transpose();
  for (int at = 3; at < n; at += 2) covariance_(at, at + 1) = covariance_(at + 1, at);
  return white.squaredNorm();
}

}  // namespace falko_slam
