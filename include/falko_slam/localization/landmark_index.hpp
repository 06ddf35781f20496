// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "falko_slam/localization/landmark.hpp"
#include "falko_slam/localization/landmark_map.hpp"

namespace falko_slam {

/// A fixed map whose landmarks are found by place and by id. Square cells of about two landmarks
/// each: a search costs what lies in the cells that its circle touches.
class LandmarkIndex {
 public:
  /// Throws std::invalid_argument that names the id where one appears twice, or a landmark is not
  /// finite or its covariance not positive semidefinite.
  explicit LandmarkIndex(std::vector<Landmark> landmarks);

  const std::vector<Landmark>& landmarks() const { return landmarks_; }

  /// Puts the places in landmarks() of all within `radius` [m] of the point into `found`, in no
  /// particular order. An infinite radius finds all.
  void find_near(const Eigen::Vector2d& point, double radius,
                 std::vector<std::size_t>& found) const;

  std::optional<std::size_t> find(std::uint32_t id) const;

  /// The square root of the greatest eigenvalue of all covariances [m].
  double largest_deviation() const { return largest_deviation_; }

 private:
  int column_of(double x) const;
  int row_of(double y) const;
  std::size_t cell_of(const Eigen::Vector2d& point) const;
  void sort_into_cells();

  std::vector<Landmark> landmarks_;
  std::unordered_map<std::uint32_t, std::size_t> place_of_;
  double largest_deviation_ = 0.0;
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  double cells_per_metre_ = 1.0;
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> begin_;  // of each cell in members_, and one past the last
  std::vector<std::size_t> members_;
};

/// Of all landmarks of a map. Throws as validate(LandmarkMap) does.
std::shared_ptr<const LandmarkIndex> landmark_index(const LandmarkMap& map);

}  // namespace falko_slam
