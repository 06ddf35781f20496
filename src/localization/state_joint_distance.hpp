// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <vector>

#include "joint_search.hpp"
#include "landmark_state.hpp"

namespace falko_slam {

/// The joint distance where landmarks hang together with each other: the Cholesky factor of the
/// joint innovation covariance, two rows for each pair.
class StateJointDistance : public JointDistance {
 public:
  /// `most`: pairs at a time.
  StateJointDistance(const LandmarkState& state, const std::vector<LandmarkState::Row>& rows,
                     std::size_t most)
      : rows_(rows),
        slopes_(state.size(), first_row(rows.size())),
        L_(first_row(most), first_row(most)),
        white_(first_row(most)),
        chosen_(most) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      state.covariance_with(rows[i], slopes_.middleCols<2>(first_row(i)));
    }
  }

  double with(std::size_t count, std::size_t pair) override {
    chosen_[count] = pair;
    const LandmarkState::Row& row = rows_[pair];
    const Eigen::Index at = first_row(count);
    for (std::size_t j = 0; j <= count; ++j) {
      L_.block<2, 2>(at, first_row(j)) = between(row, chosen_[j]);
    }
    Eigen::Matrix2d rest = L_.block<2, 2>(at, at) + row.noise;
    for (Eigen::Index i = at; i < at + 2; ++i) {
      for (Eigen::Index c = 0; c < at; ++c) {
        L_(i, c) = (L_(i, c) - L_.row(i).head(c).dot(L_.row(c).head(c))) / L_(c, c);
      }
    }
    rest.noalias() -= L_.block(at, 0, 2, at) * L_.block(at, 0, 2, at).transpose();
    const Eigen::LLT<Eigen::Matrix2d> factor(rest);
    if (factor.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
    L_.block<2, 2>(at, at) = factor.matrixL();
    white_.segment<2>(at) =
        factor.matrixL().solve(row.innovation - L_.block(at, 0, 2, at) * white_.head(at));
    return white_.head(at + 2).squaredNorm();
  }

 private:
  static Eigen::Index first_row(std::size_t pair) { return 2 * static_cast<Eigen::Index>(pair); }

  Eigen::Matrix2d between(const LandmarkState::Row& row, std::size_t other) const {
    return LandmarkState::between(row, slopes_.middleCols<2>(first_row(other)));
  }

  const std::vector<LandmarkState::Row>& rows_;
  Eigen::MatrixXd slopes_;  // P H^T of every pair
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> L_;
  Eigen::VectorXd white_;
  std::vector<std::size_t> chosen_;
};

}  // namespace falko_slam
