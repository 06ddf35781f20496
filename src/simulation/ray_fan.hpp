// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "falko_slam/simulation/world.hpp"

namespace falko_slam {

/// Rays of a scanner that moves while it turns, all in one frame, and what each meets first. Every
/// beam is a bundle of as many rays; those of beam b are b * rays_per_beam and the following.
struct RayFan {
  std::size_t rays_per_beam = 1;
  std::vector<double> bearing;  ///< of each beam, rising, not wrapped [rad]
  double bearing_margin = 0.0;  ///< the rays of a beam look at most so far beside it [rad]
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double reach = 0.0;  ///< all rays begin so near to the center [m]; infinity: each is tried

  std::vector<double> x, y, dx, dy;  ///< begin [m] and direction (unit) of each ray
  std::vector<double> range;         ///< to what it meets first [m]; infinity: nothing
  std::vector<double> light;         ///< that this sends back, see returned_light()
  /// Of the shape that is being cast, else kNone; whole numbers, of the type of the ranges so that
  /// one vector register holds both.
  std::vector<double> target;

  static constexpr double kNone = -1.0;
  std::size_t beams() const { return bearing.size(); }
  /// Room for so many beams, whose rays have not met anything, and for an even number of rays.
  void resize(std::size_t beams);
};

/// What the rays meet of a shape, as far as it is nearer than what they have met so far.
///
/// Each face or cylinder is tried on the rays that can meet it only: the beams between the bearings
/// of its ends seen from the center, widened by what the rays' begins and directions may differ.
/// O(things log beams + rays that are tried).
void cast(const Shape& shape, const std::vector<Surface>& surfaces, RayFan& fan);

/// The same of a thing that moves: each beam meets it where it is when the beam looks.
/// `seconds[b]` is when that is, since the thing's movement began; rising.
void cast(const Body& body, const std::vector<Surface>& surfaces,
          const std::vector<double>& seconds, RayFan& fan);

}  // namespace falko_slam
