// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "stretch_fit.hpp"

namespace falko_slam {

constexpr int kCommonErrors = 2 * static_cast<int>(kDrivePhases);  // slip of the phases, then steer
using CommonVector = Eigen::Matrix<double, kCommonErrors, 1>;
using CommonMatrix = Eigen::Matrix<double, kCommonErrors, kCommonErrors>;

/// All sums over the stretches that a solution of r = H x + Z u needs, whitened by the errors of
/// each alone, by what neighbours share (W, block-tridiagonal), and by what the egomotion of a
/// phase has in common, which is known and can be taken out,
///
///     W^-1 - W^-1 E (T^-2 + E^T W^-1 E)^-1 E^T W^-1        E: one 3 x 3 identity per stretch
class WhitenedSums {
 public:
  WhitenedSums(const StretchSet& set, const FreeParameters& free,
               const std::vector<StretchPrediction>& predictions, const CalibrationNoise& noise);

  auto HtH() const { return sums_.topLeftCorner(count_, count_); }
  auto HtZ() const {
    return sums_.block<Eigen::Dynamic, kCommonErrors>(0, count_, count_, kCommonErrors);
  }
  auto ZtZ() const { return sums_.block<kCommonErrors, kCommonErrors>(count_, count_); }
  auto Htr() const { return sums_.col(last()).head(count_); }
  auto Ztr() const { return sums_.col(last()).segment<kCommonErrors>(count_); }
  double rtr() const { return sums_(last(), last()); }
  double log_determinant() const { return log_determinant_; }  ///< of the whole covariance

 private:
  Eigen::Index last() const { return count_ + kCommonErrors; }
  void take_out(const Eigen::MatrixXd& EtE, const Eigen::MatrixXd& Et_all,
                const Eigen::VectorXd& deviations);

  Eigen::Index count_;
  Eigen::MatrixXd sums_;  // of (H Z r)^T (H Z r)
  double log_determinant_ = 0.0;
};

}  // namespace falko_slam
