// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "whitened_sums.hpp"

#include <Eigen/Cholesky>

namespace falko_slam {
namespace {

constexpr Eigen::Index kMotions = 3 * static_cast<Eigen::Index>(kDrivePhases);  // columns of E

}  // namespace

WhitenedSums::WhitenedSums(const StretchSet& set, const FreeParameters& free,
                           const std::vector<StretchPrediction>& predictions,
                           const CalibrationNoise& noise)
    : count_(free.count()) {
  using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic>;
  const Eigen::Index columns = last() + 1 + kMotions;  // H Z r E
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(columns, columns);
  Rows before;                     // whitened, of the stretch before
  Eigen::Matrix3d before_to_here;  // its factor in the decomposition of W
  bool linked = false;
  for (std::size_t i = 0; i < set.stretches.size(); ++i) {
    if (!set.used[i]) {
      linked = false;
      continue;
    }
    const StretchPrediction& prediction = predictions[i];
    const auto phase = static_cast<Eigen::Index>(set.phases[i]);
    Rows rows = Rows::Zero(3, columns);
    rows.leftCols(count_) = prediction.dparameters * free.columns;
    rows.col(count_ + phase) = prediction.dslip;
    rows.col(count_ + phase + static_cast<Eigen::Index>(kDrivePhases)) = prediction.dsteer;
    rows.col(last()) = set.stretches[i].motion - prediction.motion;
    rows.middleCols<3>(last() + 1 + 3 * phase).setIdentity();
    Eigen::Matrix3d W = residual_covariance(set.stretches[i], prediction, noise);
    if (linked) {
      W -= before_to_here * before_to_here.transpose();
      rows -= before_to_here * before;
    }
    const Eigen::Matrix3d L = W.llt().matrixL();
    L.triangularView<Eigen::Lower>().solveInPlace(rows);
    sums += rows.transpose() * rows;
    log_determinant_ += 2.0 * L.diagonal().array().log().sum();
    before_to_here = set.stretches[i].covariance_with_next;
    L.triangularView<Eigen::Lower>().solveInPlace(before_to_here);
    before_to_here.transposeInPlace();
    before = rows;
    linked = true;
  }
  sums_ = sums.topLeftCorner(last() + 1, last() + 1);
  Eigen::VectorXd deviations(kMotions);
  for (Eigen::Index i = 0; i < kMotions; ++i) {
    deviations[i] = i % 3 == 2 ? noise.common_turn : noise.common_position;
  }
  if (deviations.maxCoeff() <= 0.0) return;
  take_out(sums.bottomRightCorner(kMotions, kMotions), sums.bottomLeftCorner(kMotions, last() + 1),
           deviations);
}

void WhitenedSums::take_out(const Eigen::MatrixXd& EtE, const Eigen::MatrixXd& Et_all,
                            const Eigen::VectorXd& deviations) {
  const Eigen::MatrixXd scaled = deviations.asDiagonal() * EtE * deviations.asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> D(Eigen::MatrixXd::Identity(kMotions, kMotions) + scaled);
  const Eigen::MatrixXd L = D.matrixL();
  const Eigen::MatrixXd common =
      L.triangularView<Eigen::Lower>().solve(deviations.asDiagonal() * Et_all);
  sums_ -= common.transpose() * common;
  log_determinant_ += 2.0 * L.diagonal().array().log().sum();
}

}  // namespace falko_slam
