// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/constellation_search.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kMostPairs = 1000000;
constexpr double kSameDistance = 0.5, kSameTurn = 0.1;  // [m], [rad]

double direction_of(const Eigen::Vector2d& vector) { return std::atan2(vector.y(), vector.x()); }

// What another place must explain beside one that explains so much: one less, of many a fifth less.
std::size_t least_of_rival(std::size_t most) { return most - std::min(most, 1 + most / 5); }

// The greatest variance of a cartesian observation, or of its bearing and range at its range.
double variance_of(const LandmarkObservation& observation) {
  Eigen::Matrix2d covariance = observation.covariance;
  if (observation.model == ObservationModel::kRangeBearing) {
    covariance.row(1) *= observation.value.x();
    covariance.col(1) *= observation.value.x();
  }
  return 0.5 * covariance.trace() +
         std::hypot(0.5 * (covariance(0, 0) - covariance(1, 1)), covariance(0, 1));
}

}  // namespace

bool are_same_place(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm() < kSameDistance &&
         std::abs(wrap_angle(a.theta() - b.theta())) < kSameTurn;
}

ConstellationSearch::ConstellationSearch(const ConstellationParams& params,
                                         const Pose2& base_T_laser,
                                         std::shared_ptr<const LandmarkIndex> map)
    : params_(params), base_T_laser_(base_T_laser), map_(std::move(map)) {
  validate(params_);
  list_map_pairs();
}

void ConstellationSearch::list_map_pairs() {
  const std::vector<Landmark>& landmarks = map_->landmarks();
  const auto by_distance = [](const MapPair& a, const MapPair& b) {
    return a.distance < b.distance;
  };
  for (std::uint32_t i = 0; i < landmarks.size(); ++i) {
    for (std::uint32_t k = i + 1; k < landmarks.size(); ++k) {
      const double distance = (landmarks[i].position - landmarks[k].position).norm();
      if (distance < 0.5 * params_.min_distance) continue;
      pairs_.push_back({static_cast<float>(distance), i, k});
    }
    if (pairs_.size() < 4 * kMostPairs) continue;
    std::nth_element(pairs_.begin(), pairs_.begin() + kMostPairs, pairs_.end(), by_distance);
    pairs_.resize(kMostPairs);
  }
  std::sort(pairs_.begin(), pairs_.end(), by_distance);
  if (pairs_.size() > kMostPairs) pairs_.resize(kMostPairs);
}

void ConstellationSearch::list_point_pairs() {
  point_pairs_.clear();
  const auto below = [](const MapPair& pair, double distance) {
    return static_cast<double>(pair.distance) < distance;
  };
  for (std::size_t i = 0; i < points_.size(); ++i) {
    for (std::size_t k = i + 1; k < points_.size(); ++k) {
      PointPair pair{i, k, (points_[k].in_laser - points_[i].in_laser).norm(), 0.0, 0, 0};
      if (pair.distance < params_.min_distance) continue;
      pair.tolerance = params_.gate * std::sqrt(points_[i].variance + points_[k].variance);
      const auto from =
          std::lower_bound(pairs_.begin(), pairs_.end(), pair.distance - pair.tolerance, below);
      const auto to = std::lower_bound(from, pairs_.end(), pair.distance + pair.tolerance, below);
      pair.begin = static_cast<std::size_t>(from - pairs_.begin());
      pair.end = static_cast<std::size_t>(to - pairs_.begin());
      point_pairs_.push_back(pair);
    }
  }
  std::sort(point_pairs_.begin(), point_pairs_.end(), [](const PointPair& a, const PointPair& b) {
    return a.end - a.begin < b.end - b.begin;
  });
}

std::vector<PlaceCandidate> ConstellationSearch::search(
    const std::vector<LandmarkObservation>& observations) {
  const double map_variance = map_->largest_deviation() * map_->largest_deviation();
  points_.clear();
  best_.clear();
  for (const LandmarkObservation& observation : observations) {
    if (!is_usable(observation)) continue;
    points_.push_back(
        {point_in_laser(observation), variance_of(observation) + map_variance, observation.kind});
  }
  if (points_.size() < static_cast<std::size_t>(params_.min_landmarks)) return {};
  list_point_pairs();
  auto left = static_cast<std::size_t>(params_.max_candidates);
  for (const PointPair& pair : point_pairs_) {
    if (2 * (pair.end - pair.begin) > left) break;
    left -= 2 * (pair.end - pair.begin);
    for (std::size_t i = pair.begin; i < pair.end; ++i) {
      try_place(pair, pairs_[i].first, pairs_[i].second);
      try_place(pair, pairs_[i].second, pairs_[i].first);
    }
  }
  std::stable_sort(best_.begin(), best_.end(),
                   [](const auto& a, const auto& b) { return a.explained > b.explained; });
  if (best_.size() > static_cast<std::size_t>(params_.max_results)) {
    best_.resize(static_cast<std::size_t>(params_.max_results));
  }
  for (PlaceCandidate& place : best_) place.map_T_base = place.map_T_base * base_T_laser_.inverse();
  return best_;
}

void ConstellationSearch::try_place(const PointPair& pair, std::uint32_t first,
                                    std::uint32_t second) {
  const std::vector<Landmark>& landmarks = map_->landmarks();
  if (landmarks[first].kind != points_[pair.first].kind ||
      landmarks[second].kind != points_[pair.second].kind) {
    return;
  }
  const Eigen::Vector2d& from = points_[pair.first].in_laser;
  const Eigen::Vector2d& to = points_[pair.second].in_laser;
  const Eigen::Vector2d& target_from = landmarks[first].position;
  const Eigen::Vector2d& target_to = landmarks[second].position;
  const Pose2 turn({0.0, 0.0}, direction_of(target_to - target_from) - direction_of(to - from));
  const Eigen::Vector2d shift = 0.5 * (target_from + target_to) - turn * (0.5 * (from + to));
  const Pose2 map_T_laser(shift, turn.theta());
  const std::size_t most = best_.empty() ? 0 : best_.front().explained;
  const std::size_t enough =
      std::max(static_cast<std::size_t>(params_.min_landmarks), least_of_rival(most));
  const std::size_t explained = explained_by(map_T_laser, pair, enough);
  if (explained >= enough) keep(map_T_laser, explained);
}

// Gives up as soon as it cannot be enough.
std::size_t ConstellationSearch::explained_by(const Pose2& map_T_laser, const PointPair& pair,
                                              std::size_t enough) {
  const Eigen::Vector2d middle =
      0.5 * (points_[pair.first].in_laser + points_[pair.second].in_laser);
  const double variance = points_[pair.first].variance + points_[pair.second].variance;
  const double turn_variance = variance / (pair.distance * pair.distance);
  std::size_t explained = 2, left = points_.size() - 2;
  for (std::size_t i = 0; i < points_.size() && explained + left >= enough; ++i) {
    if (i == pair.first || i == pair.second) continue;
    const Point& point = points_[i];
    const double lever = (point.in_laser - middle).squaredNorm();
    const double radius =
        params_.gate * std::sqrt(point.variance + 0.25 * variance + lever * turn_variance);
    --left;
    if (has_near(map_T_laser * point.in_laser, radius, point.kind)) ++explained;
  }
  return explained;
}

bool ConstellationSearch::has_near(const Eigen::Vector2d& point_in_map, double radius,
                                   LandmarkKind kind) {
  map_->find_near(point_in_map, radius, near_);
  const std::vector<Landmark>& landmarks = map_->landmarks();
  return std::any_of(near_.begin(), near_.end(),
                     [&](std::size_t number) { return landmarks[number].kind == kind; });
}

// The best one stands first.
void ConstellationSearch::keep(const Pose2& map_T_laser, std::size_t explained) {
  const auto same = std::find_if(best_.begin(), best_.end(), [&](const PlaceCandidate& place) {
    return are_same_place(place.map_T_base, map_T_laser);
  });
  if (same != best_.end()) {
    if (same->explained >= explained) return;
    *same = {map_T_laser, explained};
    if (explained > best_.front().explained) std::iter_swap(best_.begin(), same);
    return;
  }
  best_.push_back({map_T_laser, explained});
  if (explained > best_.front().explained) std::swap(best_.front(), best_.back());
  const auto worse = [&](const PlaceCandidate& place) {
    return place.explained < least_of_rival(best_.front().explained);
  };
  best_.erase(std::remove_if(best_.begin(), best_.end(), worse), best_.end());
}

}  // namespace falko_slam
