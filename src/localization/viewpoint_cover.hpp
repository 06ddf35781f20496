// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace falko_slam {

/// Groups places: one within `spacing` [m] of a viewpoint belongs to the nearest one, else it is a
/// new viewpoint.
class ViewpointCover {
 public:
  explicit ViewpointCover(double spacing) : spacing_(spacing) {}

  /// The number of the viewpoint that the place belongs to.
  std::size_t add(const Eigen::Vector2d& place) {
    const CellPlace cell = cell_of(place);
    double nearest = spacing_;
    std::size_t viewpoint = places_.size();
    for (std::int64_t column = cell.first - 1; column <= cell.first + 1; ++column) {
      for (std::int64_t row = cell.second - 1; row <= cell.second + 1; ++row) {
        const auto members = cells_.find({column, row});
        if (members == cells_.end()) continue;
        for (const std::size_t member : members->second) {
          const double distance = (places_[member] - place).norm();
          if (distance >= nearest) continue;
          nearest = distance;
          viewpoint = member;
        }
      }
    }
    if (viewpoint == places_.size()) {
      places_.push_back(place);
      cells_[cell].push_back(viewpoint);
    }
    return viewpoint;
  }

  std::size_t size() const { return places_.size(); }

 private:
  using CellPlace = std::pair<std::int64_t, std::int64_t>;  // column, row

  CellPlace cell_of(const Eigen::Vector2d& place) const {
    return {static_cast<std::int64_t>(std::floor(place.x() / spacing_)),
            static_cast<std::int64_t>(std::floor(place.y() / spacing_))};
  }

  double spacing_;
  std::vector<Eigen::Vector2d> places_;
  std::map<CellPlace, std::vector<std::size_t>> cells_;  // the viewpoints in each
};

}  // namespace falko_slam
