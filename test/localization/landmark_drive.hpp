// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/localization/pose_filter.hpp"
#include "support/seeds.hpp"

namespace falko_slam {
namespace test {

/// base_T_laser of a laser that is turned and beside the middle.
inline const Pose2 kLaserMount(1.2, -0.3, 0.4);

/// A vector of this covariance.
template <int N>
Eigen::Matrix<double, N, 1> drawn(const Eigen::Matrix<double, N, N>& covariance,
                                  std::mt19937_64& random) {
  Eigen::Matrix<double, N, 1> white;
  for (int i = 0; i < N; ++i) white[i] = normal(random, 1.0);
  return covariance.llt().matrixL() * white;
}

/// Normalised estimation error squared, 3 degrees of freedom.
inline double nees(const PoseEstimate& estimate, const Pose2& truth) {
  const Eigen::Vector3d error = difference(estimate.pose, truth);
  return error.dot(estimate.covariance.ldlt().solve(error));
}

inline Pose2 disturbed(const PoseEstimate& estimate, std::mt19937_64& random) {
  const Eigen::Vector3d error = drawn<3>(estimate.covariance, random);
  return {estimate.pose.x() + error.x(), estimate.pose.y() + error.y(),
          estimate.pose.theta() + error.z()};
}

/// What the laser sees of a landmark, without noise.
inline LandmarkObservation seen(ObservationModel model, const Pose2& map_T_base,
                                const Pose2& base_T_laser, const Eigen::Vector2d& position,
                                const Eigen::Matrix2d& covariance) {
  const auto prediction = predict_observation(model, map_T_base, base_T_laser, position);
  return {model, prediction.value, covariance, std::nullopt};
}

inline LandmarkObservation noisy(LandmarkObservation observation, std::mt19937_64& random) {
  observation.value += drawn<2>(observation.covariance, random);
  return observation;
}

inline Eigen::Matrix2d diagonal(double a, double b) {
  return Eigen::Vector2d(a * a, b * b).asDiagonal();
}

/// Landmarks evenly in a square about the origin, none nearer to another than `apart` [m].
inline std::vector<Landmark> scattered_landmarks(std::size_t count, double size, double apart,
                                                 double deviation, std::mt19937_64& random) {
  std::vector<Landmark> landmarks;
  while (landmarks.size() < count) {
    const double x = uniform(random, -0.5 * size, 0.5 * size);
    const Eigen::Vector2d position(x, uniform(random, -0.5 * size, 0.5 * size));
    bool free = true;
    for (const Landmark& other : landmarks) {
      free = free && (other.position - position).norm() >= apart;
    }
    const auto id = static_cast<std::uint32_t>(landmarks.size());
    if (free) landmarks.push_back({id, position, diagonal(deviation, deviation)});
  }
  return landmarks;
}

}  // namespace test
}  // namespace falko_slam
