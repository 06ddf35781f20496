// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "falko_slam/geometry/line2.hpp"
#include "falko_slam/sensor/laser_scan.hpp"
#include "falko_slam/sensor/surface_step.hpp"

namespace falko_slam {

/// Defaults: a SICK NAV350 (\cite sick2017nav350) among pallets.
struct FaceDetectorParams {
  /// Farther beams are left out. [0.1, 1e5] [m]
  double max_range = 15.0;
  /// Standard deviation of the range of one beam. [1e-4, 1] [m]
  double range_noise = 0.008;
  /// Standard deviation of the direction of one beam. [0, 0.1] [rad]
  double bearing_noise = 3.5e-4;
  /// How far a face's own shape strays from a straight line, and what of it is seen from one place
  /// and not from another: standard deviation. Greater: faces that stand nearly in line with each
  /// other are taken for one. [1e-4, 0.1] [m]
  double straightness = 0.005;
  /// Beams left out at either end, whose light falls on what is beside the face, too. [0, 100]
  int end_beams = 1;
  /// Without these; fewer are no face. [3, 1000]
  int min_beams = 5;
  /// Shorter ones tell little of a direction. [0.01, 100] [m]
  double min_length = 0.3;
  SurfaceStepParams surface;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const FaceDetectorParams& params);

/// A straight face: beams side by side on one line.
struct DetectedFace {
  Line2 line;  ///< in the frame of the laser, the normal leading away from it
  /// Of (direction of the normal [rad], distance of the middle across the face [m]).
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of what is seen, on the line [m]
  double half_length = 0.0;                          ///< [m]
  std::size_t first_beam = 0;
  std::size_t last_beam = 0;  ///< less than the first one across the seam of a closed scan
};

/// Straight faces of a scan that is free of motion, in the order of their beams.
///
/// Each connected surface is split where it strays farthest from its chord (\cite douglas1973)
/// until every beam lies on its line to within what noise and straightness allow; then where two
/// lines explain it so much better that neither chance nor straightness does: pallets side by side,
/// one a centimetre behind the other, taken for one face, would seem to turn as one drives by. The
/// noise of a
/// beam across a face with normal n is that of its range times n . u and of its bearing times
/// r n . u', with u along the beam and u' across it: on a face seen at a grazing angle a step of
/// two centimetres stands out from a range noise of one. The line of a face is that of all its
/// stretches alike.
/// O(beams log beams).
std::vector<DetectedFace> detect_faces(const LaserScan& scan, const FaceDetectorParams& params);

}  // namespace falko_slam
