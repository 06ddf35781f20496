// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/sensor/surface_step.hpp"

namespace falko_slam {

/// The beams of a scan counted from a place where no surface goes on, so that none is cut by the
/// seam of a scan that closes on itself.
class UnrolledScan {
 public:
  UnrolledScan() = default;
  /// Beams that are not valid, or farther than `max_range` [m], are not usable.
  UnrolledScan(const LaserScan& scan, double max_range, const SurfaceStepParams& surface);

  std::size_t size() const { return points_.size(); }
  bool usable(std::size_t k) const { return ranges_[k] > 0.0; }
  double range(std::size_t k) const { return ranges_[k]; }  ///< 0 if it is not usable [m]
  const Eigen::Vector2d& point(std::size_t k) const { return points_[k]; }

  /// Of the beam that is k here: its number in the scan, and back.
  std::size_t beam_of(std::size_t k) const { return (start_ + k) % size(); }
  std::size_t place_of(std::size_t beam) const { return (beam + size() - start_) % size(); }

  /// Calls visit(first, last) for each run of usable beams of which each lies on one surface with
  /// the next (on_one_surface()).
  template <class Visit>
  void for_each_surface(Visit&& visit) const {
    for (std::size_t first = 0, k = 1; k <= size(); ++k) {
      if (k < size() && joined_[k]) continue;
      if (usable(first)) visit(first, k - 1);
      first = k;
    }
  }

 private:
  std::size_t start_ = 0;
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> ranges_;
  std::vector<bool> joined_;  // with the one before
};

}  // namespace falko_slam
