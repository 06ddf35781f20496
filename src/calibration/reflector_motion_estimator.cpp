// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/reflector_motion_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

Eigen::Vector2d mean_of(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

double squares_about_mean(const std::vector<Eigen::Vector2d>& points) {
  const Eigen::Vector2d mean = mean_of(points);
  double sum = 0.0;
  for (const Eigen::Vector2d& point : points) sum += (point - mean).squaredNorm();
  return sum;
}

// What is seen now and then only, such as a reflector half hidden, is no landmark.
bool lasting(std::size_t seen, std::size_t scans) { return seen > 0 && 2 * seen >= scans; }

}  // namespace

void validate(const ReflectorMotionParams& params) {
  require_in_range("gate_distance", params.gate_distance, 0.001, 10.0);
  require_in_range("gate_share", params.gate_share, 0.0, 1.0);
  require_in_range("detection_noise", params.detection_noise, 1e-9, 1.0);
  require_in_range("lasting_noise", params.lasting_noise, 0.0, 1.0);
  require_in_range<std::size_t>("min_reflectors", params.min_reflectors, 2, 1000);
}

ReflectorMotionEstimator::ReflectorMotionEstimator(const ReflectorMotionParams& params)
    : params_(params) {
  validate(params);
}

// Mutual nearest neighbours within the gate.
std::vector<ReflectorMotionEstimator::Pair> ReflectorMotionEstimator::associate(
    const ReflectorPoints& points, const Pose2& start_T_laser) const {
  std::vector<Pair> pairs;
  std::vector<double> distances(landmarks_.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> nearest_point(landmarks_.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d in_start = start_T_laser * points[i];
    std::size_t nearest = landmarks_.size();
    double least = params_.gate_distance + params_.gate_share * points[i].norm();
    for (std::size_t k = 0; k < landmarks_.size(); ++k) {
      const double distance = (landmarks_[k].in_start - in_start).norm();
      if (distance >= least) continue;
      least = distance;
      nearest = k;
    }
    if (nearest == landmarks_.size() || least >= distances[nearest]) continue;
    distances[nearest] = least;
    nearest_point[nearest] = i;
  }
  for (std::size_t k = 0; k < landmarks_.size(); ++k) {
    if (nearest_point[k] < points.size()) pairs.push_back({k, nearest_point[k]});
  }
  return pairs;
}

// Lays the scan over what is known; the pose is mended if that can be done.
std::vector<ReflectorMotionEstimator::Pair> ReflectorMotionEstimator::fit(
    const ReflectorPoints& points) {
  constexpr int kRounds = 3;
  std::vector<Pair> pairs = associate(points, start_T_laser_);
  for (int round = 0; round < kRounds && pairs.size() >= 2; ++round) {
    std::vector<PointPair> seen_twice;
    seen_twice.reserve(pairs.size());
    for (const Pair& pair : pairs) {
      seen_twice.push_back({landmarks_[pair.landmark].in_start, points[pair.point]});
    }
    const auto alignment = align(seen_twice, params_.detection_noise);
    if (!alignment) break;
    start_T_laser_ = alignment->target_T_source.pose;
    pairs = associate(points, start_T_laser_);
  }
  if (pairs.size() < 2) ++lost_scans_;
  return pairs;
}

void ReflectorMotionEstimator::move(const Pose2& step) {
  const double before = start_T_laser_.theta();
  start_T_laser_ = start_T_laser_ * step;
  turn_ += angle_between(before, start_T_laser_.theta());
}

void ReflectorMotionEstimator::add_new(const ReflectorPoints& points,
                                       const std::vector<Pair>& known) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&](const Pair& pair) { return pair.point == i; });
    if (!is_known) landmarks_.push_back({start_T_laser_ * points[i], {}, {}});
  }
}

void ReflectorMotionEstimator::add_at_start(const ReflectorPoints& points) {
  ++scans_;
  ++scans_at_start_;
  std::vector<Pair> known = associate(points, Pose2());
  const std::size_t before = landmarks_.size();
  add_new(points, known);
  if (landmarks_.size() > before) known = associate(points, Pose2());
  for (const Pair& pair : known) {
    Landmark& landmark = landmarks_[pair.landmark];
    landmark.at_start.push_back(points[pair.point]);
    landmark.in_start = mean_of(landmark.at_start);
  }
}

void ReflectorMotionEstimator::add_on_the_way(const ReflectorPoints& points, const Pose2& step) {
  ++scans_;
  move(step);
  const double expected = start_T_laser_.theta();
  const std::vector<Pair> known = fit(points);
  turn_ += angle_between(expected, start_T_laser_.theta());
  if (known.size() >= 2) add_new(points, known);
}

void ReflectorMotionEstimator::add_at_end(const ReflectorPoints& points, const Pose2& step) {
  ++scans_;
  ++scans_at_end_;
  if (!ended_) move(step);
  ended_ = true;
  const double expected = start_T_laser_.theta();
  for (const Pair& pair : fit(points)) {
    landmarks_[pair.landmark].at_end.push_back(points[pair.point]);
  }
  turn_ += angle_between(expected, start_T_laser_.theta());
}

// Standard deviation of a coordinate of one detection, of all that were repeated at rest [m].
double ReflectorMotionEstimator::noise_at_rest() const {
  double squares = 0.0;
  double freedom = 0.0;
  for (const Landmark& landmark : landmarks_) {
    for (const auto* at_rest : {&landmark.at_start, &landmark.at_end}) {
      if (at_rest->size() < 2) continue;
      squares += squares_about_mean(*at_rest);
      freedom += 2.0 * static_cast<double>(at_rest->size() - 1);
    }
  }
  const double seen = freedom > 0.0 ? std::sqrt(squares / freedom) : 0.0;
  return std::max(seen, params_.detection_noise);
}

std::optional<ReflectorMotion> ReflectorMotionEstimator::result() const {
  const double noise = noise_at_rest();
  const auto variance_of = [&](const std::vector<Eigen::Vector2d>& seen) {
    return noise * noise / static_cast<double>(seen.size()) +
           params_.lasting_noise * params_.lasting_noise;
  };
  std::vector<PointPair> pairs;
  for (const Landmark& landmark : landmarks_) {
    if (!lasting(landmark.at_start.size(), scans_at_start_)) continue;
    if (!lasting(landmark.at_end.size(), scans_at_end_)) continue;
    const double variance = variance_of(landmark.at_start) + variance_of(landmark.at_end);
    pairs.push_back({mean_of(landmark.at_start), mean_of(landmark.at_end), 1.0 / variance});
  }
  drop_outliers(pairs, params_.min_reflectors);
  if (pairs.size() < params_.min_reflectors) {
    complaint_ = "only " + std::to_string(pairs.size()) + " reflectors seen at both ends, of " +
                 std::to_string(landmarks_.size()) + " in all";
    return std::nullopt;
  }
  auto motion = motion_of(std::move(pairs));
  if (!motion) {
    complaint_ = "the reflectors seen at both ends are all in one place";
    return std::nullopt;
  }
  motion->turn = unwrapped_turn(motion->start_T_end.pose.theta(), turn_);
  motion->scans = scans_;
  return motion;
}

}  // namespace falko_slam
