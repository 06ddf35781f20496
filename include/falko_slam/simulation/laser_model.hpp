// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "falko_slam/common/time.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

/// What a scanner sees and how badly; default: a SICK NAV350 by its manual (\cite sick2017nav350)
/// where that says something.
struct LaserModel {
  std::size_t beams = 1440;
  double angle_min = -kPi;                   ///< bearing of the first beam [rad]
  double angle_increment = kTwoPi / 1440.0;  ///< positive: counter-clockwise [rad]
  double scan_period = 0.125;                ///< from a first beam to the next one [s]
  double time_increment = 0.125 / 1440.0;    ///< from beam to beam [s]

  double nearest = 0.5;     ///< nothing nearer is measured [m]
  double farthest = 100.0;  ///< nor farther [m]
  /// A matt surface of a tenth of white, facing the beam, is seen up to here [m]; darker or slanted
  /// ones less far, brighter ones farther: the power falls with the square of the range.
  double range_of_dark = 35.0;
  double beam_diameter = 0.020;    ///< where it leaves the scanner [m]
  double beam_divergence = 0.005;  ///< growth of the diameter per metre
  double echo_separation = 0.3;    ///< surfaces nearer to each other give one mixed echo [m]

  double range_noise = 0.008;  ///< standard deviation of a strong echo; of the weakest sqrt 2 [m]
  double range_step = 0.001;   ///< ranges are multiples of it [m]; 0: of nothing
  double bearing_noise = 3.5e-4;  ///< standard deviation of a beam's direction [rad]
  double drop_out = 5e-4;         ///< share of beams that come back without an echo

  bool intensities = true;
  double white_intensity = 4000.0;  ///< of a white surface 1 m away; rounded, at most 65535
  double intensity_exponent = 0.4;  ///< of the received power: receivers compress

  double stated_range_min = 0.05;   ///< range_min of the messages [m]
  double stated_range_max = 100.0;  ///< range_max of the messages [m]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const LaserModel& laser);

/// From the first beam of a scan to its last one.
Duration sweep_of(const LaserModel& laser);

/// A safety scanner like the S300: 270 degrees at half a degree, 30 m, no intensities.
LaserModel s300();

}  // namespace falko_slam
