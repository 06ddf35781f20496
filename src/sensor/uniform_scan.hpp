// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// A scan of the same beams as another one, filled in any order; the nearest range counts. Places
/// are numbers of beams; on a closed scan those beyond the ends are the others' ends.
class UniformScan {
 public:
  explicit UniformScan(const LaserScan& scan) : bearings_(scan.size()) {
    scan_.angle_min = scan.angle_min;
    scan_.angle_increment = scan.angle_increment;
    scan_.range_max = scan.range_max;
    scan_.closed = scan.closed;
    scan_.reversed = scan.reversed;
    const Eigen::Vector2d step(std::cos(scan.angle_increment), std::sin(scan.angle_increment));
    Eigen::Vector2d bearing(std::cos(scan.angle_min), std::sin(scan.angle_min));
    for (Eigen::Vector2d& each : bearings_) {
      each = bearing;
      bearing = {step.x() * bearing.x() - step.y() * bearing.y(),
                 step.y() * bearing.x() + step.x() * bearing.y()};
    }
    source_ = scan.intensities;
    scan_.intensities.assign(source_.size(), std::numeric_limits<float>::quiet_NaN());
    scan_.ranges.assign(scan.size(), std::numeric_limits<double>::quiet_NaN());
    scan_.status.assign(scan.size(), BeamStatus::kErroneous);
  }

  /// Of a place; the first beam's if there is no such beam.
  const Eigen::Vector2d& bearing(std::ptrdiff_t place) const {
    const std::size_t beam = beam_at(place);
    return bearings_[beam < bearings_.size() ? beam : 0];
  }

  /// What the beam `source` of the other scan saw.
  void offer(std::ptrdiff_t place, double range, std::size_t source) {
    const std::size_t beam = beam_at(place);
    if (beam >= scan_.size() || !(range > 0.0)) return;
    if (scan_.valid(beam) && scan_.ranges[beam] <= range) return;
    if (range > scan_.range_max) return mark(place, BeamStatus::kTooFar);
    scan_.ranges[beam] = range;
    scan_.status[beam] = BeamStatus::kValid;
    if (!source_.empty()) scan_.intensities[beam] = source_[source];
  }

  /// Why there is no range, where nothing else is known.
  void mark(std::ptrdiff_t place, BeamStatus status) {
    const std::size_t beam = beam_at(place);
    if (beam < scan_.size() && scan_.status[beam] == BeamStatus::kErroneous) {
      scan_.status[beam] = status;
    }
  }

  LaserScan take(Time instant) {
    scan_.first_beam_time = instant;
    scan_.time_increment = Duration::zero();
    return std::move(scan_);
  }

 private:
  std::size_t beam_at(std::ptrdiff_t place) const {
    const auto count = static_cast<std::ptrdiff_t>(scan_.size());
    if (scan_.closed) {
      if (place < 0) place += count;
      if (place >= count) place -= count;
    }
    return static_cast<std::size_t>(place >= 0 && place < count ? place : count);
  }

  LaserScan scan_;
  std::vector<Eigen::Vector2d> bearings_;
  std::vector<float> source_;  // intensities
};

}  // namespace falko_slam
