// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "beam_directions.hpp"
#include "falko_slam/features/neighborhood_params.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// A point relative to the point of some beam: x away from the sensor, y counter-clockwise [m].
struct Offset {
  float x;
  float y;
};

/// Consecutive beams, at most kLanes of them, whose neighbours are looked at in the same steps.
struct BeamBlock {
  std::size_t first;
  std::size_t count;
  std::int32_t stride;  ///< beams between two sampled points
  std::int32_t steps;   ///< sampled points that may lie within the radius of any of the beams
};

/// A scan prepared for looking at the neighbourhoods of its beams: ranges smoothed, and for each
/// beam how far and in which steps its neighbours are looked at.
///
/// Everything is computed from ranges and differences of beam numbers alone, so that it does not
/// depend on where a closed scan starts. Single precision: a micrometre at 10 m.
class SampledScan {
 public:
  enum class Side { kRight = -1, kLeft = 1 };  ///< towards smaller or greater bearings

  explicit SampledScan(const NeighborhoodParams& params);

  /// Keeps its memory between scans. Needs at least two beams and a positive increment.
  void assign(const LaserScan& scan);

  std::size_t size() const { return bin_.size(); }
  const std::vector<BeamBlock>& blocks() const { return blocks_; }

  /// Smoothed ranges [m] from `beam` on; NaN where the beam is not valid. As many beams as its
  /// steps reach, and kLanes more, can be read on either side.
  const float* ranges(std::size_t beam) const { return smooth_.data() + margin_ + beam; }
  /// Squared radii of the neighbourhoods [m^2], from `beam` on, with kLanes to spare.
  const float* radius_squares(std::size_t beam) const { return radius_square_.data() + beam; }
  /// Unit vector along the beam, in the laser frame.
  const Eigen::Vector2d& direction(std::size_t beam) const { return directions_[beam]; }
  float cosine(std::ptrdiff_t lag) const { return cosine_[static_cast<std::size_t>(lag)]; }
  float sine(std::ptrdiff_t lag) const { return sine_[static_cast<std::size_t>(lag)]; }

  /// Calls `use(offset)` for every sampled point within the radius on that side, nearest first.
  template <class Use>
  void for_each(std::size_t beam, Side side, Use&& use) const {
    const float* center = ranges(beam);
    const float radius_square = radius_square_[beam];
    const std::int32_t steps = bin(beam).steps;
    const std::ptrdiff_t stride = bin(beam).stride;
    const float* cosines = cosine_.data();
    const float* sines = sine_.data();
    const int sign = static_cast<int>(side);
    std::ptrdiff_t lag = 0;
    for (std::int32_t step = 1; step <= steps; ++step) {
      lag += stride;
      const float range = center[sign * lag];
      const Offset point{range * cosines[lag] - *center,
                         static_cast<float>(sign) * range * sines[lag]};
      if (point.x * point.x + point.y * point.y <= radius_square) use(point);
    }
  }

 private:
  // What follows from a beam's range alone, tabulated over it.
  struct RangeBin {
    float radius_square;
    std::int32_t stride;
    std::int32_t steps;
    std::int32_t half_window;  // beams averaged on either side
  };

  const RangeBin& bin(std::size_t beam) const {
    return bins_[static_cast<std::size_t>(bin_[beam])];
  }
  void build_tables(const LaserScan& scan);
  RangeBin range_bin(double range) const;
  void look_up_ranges(const LaserScan& scan);
  void make_blocks();
  void fill_margins(std::vector<float>& ranges) const;
  void average_ranges();

  NeighborhoodParams params_;

  BeamDirections directions_;
  double angle_increment_ = 0.0;
  bool closed_ = false;
  std::vector<float> cosine_, sine_;  // of multiples of the angle increment
  std::vector<RangeBin> bins_;

  std::vector<std::int32_t> bin_;  // of each beam
  std::vector<float> radius_square_;
  std::vector<BeamBlock> blocks_;

  // These carry margin_ beams more at both ends: of a closed scan its other end, else NaN.
  std::size_t margin_ = 0;
  std::vector<float> raw_, smooth_;
};

}  // namespace falko_slam
