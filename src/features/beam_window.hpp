// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// The beams that may lie or pass within a radius of a keypoint: so many on either side of its own.
struct BeamWindow {
  std::ptrdiff_t below, above;
};

inline BeamWindow window_around(const LaserScan& scan, const Keypoint& keypoint,
                                const Eigen::Vector2d& direction, double radius) {
  const auto beams = static_cast<std::ptrdiff_t>(scan.size());
  const auto center = static_cast<std::ptrdiff_t>(keypoint.beam);
  const BeamWindow whole =
      scan.closed ? BeamWindow{(beams - 1) / 2, beams / 2} : BeamWindow{center, beams - 1 - center};
  // As seen along the keypoint's beam, which its refined position may lie off.
  const double along = keypoint.position.dot(direction);
  const double off = (keypoint.position - along * direction).norm();
  const double sine = (radius + off) / along;
  if (!(sine > 0.0 && sine < 1.0)) return whole;
  const double angle =  // at least asin(sine)
      sine < 0.5 ? sine * (1.0 + 0.19 * sine * sine) : std::asin(sine);
  const auto lag = static_cast<std::ptrdiff_t>(std::ceil(angle / scan.angle_increment));
  return {std::min(lag, whole.below), std::min(lag, whole.above)};
}

/// Calls visit(begin, end) for the beams of the window, which on a closed scan may reach over the
/// seam.
template <class Visit>
void for_each_run(const LaserScan& scan, const Keypoint& keypoint, const BeamWindow& window,
                  Visit&& visit) {
  const auto beams = static_cast<std::ptrdiff_t>(scan.size());
  const auto first = static_cast<std::ptrdiff_t>(keypoint.beam) - window.below;
  const auto last = static_cast<std::ptrdiff_t>(keypoint.beam) + window.above;
  const auto call = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    visit(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
  };
  if (first < 0) call(first + beams, beams);
  call(std::max<std::ptrdiff_t>(first, 0), std::min(last + 1, beams));
  if (last >= beams) call(0, last + 1 - beams);
}

}  // namespace falko_slam
