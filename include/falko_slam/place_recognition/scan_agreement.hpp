// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "falko_slam/geometry/pose2.hpp"
#include "falko_slam/place_recognition/scan_view.hpp"

namespace falko_slam {

struct AgreementParams {
  /// A point within this distance of the other scan's surface agrees with it. [0.001, 10] [m]
  double tolerance = 0.10;
  /// A point this far in front of what the other scan saw in its direction contradicts it: the beam
  /// has passed through. [0, 100] [m]
  double see_through = 0.30;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const AgreementParams& params);

/// What one scan says of the points of another one. Numbers of points, and lengths of wall [m].
struct Agreement {
  std::size_t points = 0;        ///< all of them
  std::size_t agreeing = 0;      ///< within the tolerance of the surface
  std::size_t missed = 0;        ///< in view, but not on the surface
  std::size_t seen_through = 0;  ///< in front of the surface
  double length = 0.0;
  double agreeing_length = 0.0;
  double missed_length = 0.0;
  double seen_through_length = 0.0;

  /// Points that the other scan could say something about.
  std::size_t seen() const { return agreeing + missed + seen_through; }
  /// Share of the wall in view that agrees; 0 if nothing is in view.
  double ratio() const {
    const double seen_length = agreeing_length + missed_length + seen_through_length;
    return seen_length > 0.0 ? agreeing_length / seen_length : 0.0;
  }
  Agreement& operator+=(const Agreement& other);
};

/// How the points of `source` fit to what `target` saw. Points behind the target's surface, outside
/// of its view or at its invalid beams are not counted. Takes every `stride`-th point.
Agreement agreement(const ScanView& target, const ScanView& source, const Pose2& target_T_source,
                    const AgreementParams& params = {}, std::size_t stride = 1);

}  // namespace falko_slam
