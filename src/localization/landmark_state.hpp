// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "falko_slam/geometry/pose_estimate.hpp"

namespace falko_slam {

/// Mean and covariance of a pose (x, y, theta) and of landmarks of two numbers each, in one matrix
/// that grows to what it holds at most and stays so; a copy is as small as it can be. Landmark i is
/// at 3 + 2 i.
class LandmarkState {
 public:
  LandmarkState(const PoseEstimate& pose, int most);
  LandmarkState(const LandmarkState& other);
  LandmarkState& operator=(const LandmarkState& other);
  LandmarkState(LandmarkState&&) = default;
  LandmarkState& operator=(LandmarkState&&) = default;
  ~LandmarkState() = default;

  int landmarks() const { return landmarks_; }
  int most() const { return most_; }
  int size() const { return 3 + 2 * landmarks_; }
  PoseEstimate pose() const;
  Eigen::Vector2d mean_of(int landmark) const { return mean_.segment<2>(3 + 2 * landmark); }
  Eigen::Matrix2d covariance_of(int landmark) const;
  auto covariance() const { return covariance_.topLeftCorner(size(), size()); }

  /// Moves the pose; landmarks stay.
  void predict(const PoseEstimate& motion);

  /// Adds to the variances of a landmark.
  void loosen(int landmark, const Eigen::Vector2d& variances);

  /// A landmark l = g(pose, z) with its slopes and the noise of z. There must be room.
  void add(const Eigen::Vector2d& mean, const Eigen::Matrix<double, 2, 3>& dlandmark_dpose,
           const Eigen::Matrix2d& noise);

  /// Marginalises it; the last landmark takes its place.
  void remove(int landmark);

  /// What an observation of a landmark changes with: z = h + Hq dq + Hl dl. Of a landmark that is
  /// not in the state there is no dl: what is not known of its place is in the noise.
  struct Row {
    static constexpr int kOutside = -1;
    int landmark = kOutside;
    bool inside() const { return landmark != kOutside; }
    Eigen::Matrix<double, 2, 3> dpose;
    Eigen::Matrix2d dlandmark;
    Eigen::Vector2d innovation;
    Eigen::Matrix2d noise;
  };
  /// P H^T of one observation, all rows of the state.
  void covariance_with(const Row& row, Eigen::Ref<Eigen::MatrixXd> result) const;
  /// H (P H'^T) from that of another one.
  static Eigen::Matrix2d between(const Row& row, const Eigen::Ref<const Eigen::MatrixXd>& other);
  /// H P H^T + N of one observation.
  Eigen::Matrix2d innovation_covariance(const Row& row) const;

  /// The normalised innovation squared. With S = L L^T and V = P H^T L^-T: x += V L^-1 nu,
  /// P -= V V^T. Less than zero and all as it was if the result were not finite or no covariance:
  /// where P is so vague, deviations of 10 km and more, that the difference is rounding alone.
  double correct(const std::vector<Row>& rows);

 private:
  static constexpr std::size_t kBatch = 8;
  void make_room();
  double correct_in_batches(const std::vector<Row>& rows, Eigen::VectorXd& step);
  double correct_batch(const std::vector<Row>& rows, Eigen::VectorXd& step);
  bool is_left_of(const Eigen::MatrixXd& before) const;

  int most_;
  int landmarks_ = 0;
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
  Eigen::MatrixXd slopes_;  // P H^T of a batch, then V
};

}  // namespace falko_slam
