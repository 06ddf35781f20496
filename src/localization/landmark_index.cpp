// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_index.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "covariance_check.hpp"

namespace falko_slam {
namespace {

[[noreturn]] void refuse(const Landmark& landmark, const char* what) {
  throw std::invalid_argument("landmark " + std::to_string(landmark.id) + ": " + what);
}

double deviation_of(const Eigen::Matrix2d& covariance) {
  const double middle = 0.5 * covariance.trace();
  const double half = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(middle + std::hypot(half, covariance(0, 1)));
}

}  // namespace

LandmarkIndex::LandmarkIndex(std::vector<Landmark> landmarks) : landmarks_(std::move(landmarks)) {
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const Landmark& landmark = landmarks_[i];
    if (!landmark.position.allFinite()) refuse(landmark, "its position is not finite");
    if (!is_positive_semidefinite(landmark.covariance)) {
      refuse(landmark, "its covariance is not positive semidefinite");
    }
    if (!place_of_.emplace(landmark.id, i).second) refuse(landmark, "there are two of this id");
    largest_deviation_ = std::max(largest_deviation_, deviation_of(landmark.covariance));
  }
  sort_into_cells();
}

void LandmarkIndex::sort_into_cells() {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = low;
  if (!landmarks_.empty()) low = high = landmarks_.front().position;
  for (const Landmark& landmark : landmarks_) {
    low = low.cwiseMin(landmark.position);
    high = high.cwiseMax(landmark.position);
  }
  corner_ = low;
  const double wanted = std::max(1.0, 0.5 * static_cast<double>(landmarks_.size()));
  const Eigen::Vector2d size = (high - low).cwiseMax(1e-3);
  const double side = std::max(std::sqrt(size.x() * size.y() / wanted), size.maxCoeff() / wanted);
  cells_per_metre_ = 1.0 / side;
  columns_ = static_cast<int>(size.x() * cells_per_metre_) + 1;
  rows_ = static_cast<int>(size.y() * cells_per_metre_) + 1;

  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Landmark& landmark : landmarks_) ++begin_[cell_of(landmark.position) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  members_.resize(landmarks_.size());
  std::vector<std::size_t> next = begin_;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    members_[next[cell_of(landmarks_[i].position)]++] = i;
  }
}

int LandmarkIndex::column_of(double x) const {
  return static_cast<int>(
      std::clamp(std::floor((x - corner_.x()) * cells_per_metre_), 0.0, columns_ - 1.0));
}

int LandmarkIndex::row_of(double y) const {
  return static_cast<int>(
      std::clamp(std::floor((y - corner_.y()) * cells_per_metre_), 0.0, rows_ - 1.0));
}

std::size_t LandmarkIndex::cell_of(const Eigen::Vector2d& point) const {
  return static_cast<std::size_t>(row_of(point.y())) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column_of(point.x()));
}

void LandmarkIndex::find_near(const Eigen::Vector2d& point, double radius,
                              std::vector<std::size_t>& found) const {
  found.clear();
  const int last_column = column_of(point.x() + radius), last_row = row_of(point.y() + radius);
  for (int row = row_of(point.y() - radius); row <= last_row; ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    const std::size_t first = start + static_cast<std::size_t>(column_of(point.x() - radius));
    const std::size_t last = start + static_cast<std::size_t>(last_column);
    for (std::size_t i = begin_[first]; i < begin_[last + 1]; ++i) {
      const Eigen::Vector2d& position = landmarks_[members_[i]].position;
      if ((position - point).squaredNorm() <= radius * radius) found.push_back(members_[i]);
    }
  }
}

std::optional<std::size_t> LandmarkIndex::find(std::uint32_t id) const {
  const auto found = place_of_.find(id);
  if (found == place_of_.end()) return std::nullopt;
  return found->second;
}

std::shared_ptr<const LandmarkIndex> landmark_index(const LandmarkMap& map) {
  validate(map);
  std::vector<Landmark> landmarks;
  for (const MapLandmark& landmark : map.landmarks) {
    landmarks.push_back({static_cast<std::uint32_t>(landmark.id), landmark.position,
                         landmark.covariance, landmark.kind});
  }
  return std::make_shared<LandmarkIndex>(std::move(landmarks));
}

}  // namespace falko_slam
