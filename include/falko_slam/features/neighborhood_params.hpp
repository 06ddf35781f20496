// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace falko_slam {

/// What belongs to the neighbourhood of a beam's point, shared by the corner detectors.
struct NeighborhoodParams {
  /// a and b of the radius a exp(b range): 0.2 to 0.4 m for ranges of 1 to 10 m. [m], [1/m]
  double radius_scale = 0.20;
  double radius_growth = 0.07;
  /// The exponential stops here: at 50 m it would reach 6.6 m. [m]
  double max_radius = 1.0;
  /// Distance of the points that are looked at, as a share of the radius; nearer beams are skipped.
  /// 0: every beam. Smaller values cost more and are more easily upset by noise. [0, 0.5]
  double sample_spacing = 0.10;
  /// Ranges are averaged over this share of the radius, within one surface. 0: as measured. [0, 1]
  double smoothing_window = 0.12;
  /// Beams that meet the surface at a smaller angle on both sides are no corners: mixed pixels
  /// between two surfaces, and walls seen too flat to tell their shape. 0: all may be. [rad]
  double min_incidence = 0.175;
  /// Points that each side must have. [2, 100]
  int min_points_per_side = 2;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const NeighborhoodParams& params);

}  // namespace falko_slam
