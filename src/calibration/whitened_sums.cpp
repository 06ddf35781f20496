// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "whitened_sums.hpp"

#include <Eigen/Cholesky>

namespace falko_slam {

WhitenedSums::WhitenedSums(const StretchSet& set, const FreeParameters& free,
                           const std::vector<StretchPrediction>& predictions,
                           const CalibrationNoise& noise)
    : count_(free.count()), sums_(Eigen::MatrixXd::Zero(last() + 1, last() + 1)) {
  std::array<Phase, kDrivePhases> phases;
  for (Phase& phase : phases) phase.Et_all.setZero(3, last() + 1);
  for (std::size_t i = 0; i < set.stretches.size(); ++i) {
    if (!set.used[i]) continue;
    const StretchPrediction& prediction = predictions[i];
    const Eigen::LLT<Eigen::Matrix3d> root(
        residual_covariance(set.stretches[i], prediction, noise));
    const Eigen::Matrix3d L = root.matrixL();
    const auto slip = count_ + static_cast<Eigen::Index>(set.phases[i]);
    Eigen::Matrix<double, 3, Eigen::Dynamic> all =
        Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, last() + 1);
    all.leftCols(count_) = prediction.dparameters * free.columns;
    all.col(slip) = prediction.dslip;
    all.col(slip + static_cast<Eigen::Index>(kDrivePhases)) = prediction.dsteer;
    all.col(last()) = set.stretches[i].motion - prediction.motion;
    L.triangularView<Eigen::Lower>().solveInPlace(all);
    Eigen::Matrix3d E = Eigen::Matrix3d::Identity();
    L.triangularView<Eigen::Lower>().solveInPlace(E);
    sums_ += all.transpose() * all;
    log_determinant_ += 2.0 * L.diagonal().array().log().sum();
    phases[set.phases[i]].EtE += E.transpose() * E;
    phases[set.phases[i]].Et_all += E.transpose() * all;
  }
  const Eigen::Vector3d deviations(noise.common_position, noise.common_position, noise.common_turn);
  if (deviations.maxCoeff() <= 0.0) return;
  for (const Phase& phase : phases) take_out(phase, deviations);
}

void WhitenedSums::take_out(const Phase& phase, const Eigen::Vector3d& deviations) {
  const Eigen::Matrix3d scaled = deviations.asDiagonal() * phase.EtE * deviations.asDiagonal();
  const Eigen::LLT<Eigen::Matrix3d> D(Eigen::Matrix3d::Identity() + scaled);
  const Eigen::Matrix3d L = D.matrixL();
  const Eigen::MatrixXd common =
      L.triangularView<Eigen::Lower>().solve(deviations.asDiagonal() * phase.Et_all);
  sums_ -= common.transpose() * common;
  log_determinant_ += 2.0 * L.diagonal().array().log().sum();
}

}  // namespace falko_slam
