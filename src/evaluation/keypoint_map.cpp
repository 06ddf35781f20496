// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/keypoint_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace falko_slam {
namespace {

using Points = std::vector<Eigen::Vector2d>;

struct Nearest {
  std::size_t landmark = 0;
  double distance = std::numeric_limits<double>::infinity();
};

Nearest nearest_landmark(const std::vector<Points>& landmarks, const Eigen::Vector2d& point) {
  Nearest nearest;
  double best = nearest.distance;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const double square = (landmarks[i].front() - point).squaredNorm();
    if (square >= best) continue;
    best = square;
    nearest.landmark = i;
  }
  nearest.distance = std::sqrt(best);
  return nearest;
}

struct Deviations {
  double mean;
  double max;
};

Deviations deviations(const Points& points) {
  const auto count = static_cast<double>(points.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& point : points) mean += point / count;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& point : points) {
    covariance += (point - mean) * (point - mean).transpose() / (count - 1.0);
  }
  const double half_trace = 0.5 * covariance.trace();
  const double difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
  const double radius = std::hypot(difference, covariance(0, 1));
  const double greater = half_trace + radius;
  const double smaller = std::max(0.0, half_trace - radius);
  return {std::sqrt(std::sqrt(greater * smaller)), std::sqrt(greater)};
}

std::vector<Points> build_map(const std::vector<Points>& keypoints_by_scan,
                              const KeypointMapParams& params) {
  std::vector<Points> landmarks;
  for (const Points& keypoints : keypoints_by_scan) {
    for (const auto& point : keypoints) {
      const Nearest nearest = nearest_landmark(landmarks, point);
      if (nearest.distance < params.association_radius) {
        landmarks[nearest.landmark].push_back(point);
      } else if (nearest.distance > params.separation) {
        landmarks.push_back({point});
      }
    }
  }
  return landmarks;
}

}  // namespace

KeypointMapStatistics keypoint_map_statistics(const std::vector<Points>& keypoints_by_scan,
                                              const KeypointMapParams& params) {
  const std::vector<Points> landmarks = build_map(keypoints_by_scan, params);
  KeypointMapStatistics statistics;
  if (landmarks.empty()) return statistics;
  statistics.landmarks = static_cast<double>(landmarks.size());
  double repeated = 0.0;
  for (const Points& points : landmarks) {
    if (points.size() < 2) continue;
    const Deviations scatter = deviations(points);
    statistics.mean_deviation += scatter.mean;
    statistics.max_deviation += scatter.max;
    repeated += 1.0;
  }
  if (repeated > 0.0) {
    statistics.mean_deviation /= repeated;
    statistics.max_deviation /= repeated;
  }
  statistics.single_share = 1.0 - repeated / statistics.landmarks;
  return statistics;
}

KeypointMapStatistics shuffled_keypoint_map_statistics(std::vector<Points> keypoints_by_scan,
                                                       const KeypointMapParams& params,
                                                       std::size_t orders, std::size_t seed) {
  std::mt19937_64 random(seed);
  KeypointMapStatistics mean;
  const double share = 1.0 / static_cast<double>(orders);
  for (std::size_t i = 0; i < orders; ++i) {
    std::shuffle(keypoints_by_scan.begin(), keypoints_by_scan.end(), random);
    const KeypointMapStatistics one = keypoint_map_statistics(keypoints_by_scan, params);
    mean.landmarks += share * one.landmarks;
    mean.mean_deviation += share * one.mean_deviation;
    mean.max_deviation += share * one.max_deviation;
    mean.single_share += share * one.single_share;
  }
  return mean;
}

}  // namespace falko_slam
