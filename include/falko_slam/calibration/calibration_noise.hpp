// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace falko_slam {

/// What the encoders do not say of a stretch of the way.
struct EncoderError {
  double slip = 0.0;   ///< the share by which the way is longer than the ticks
  double steer = 0.0;  ///< what the steering is more than measured [rad]
};

/// What goes wrong on a drive, by component. The noise of the laser's motion is not here: each
/// segment brings its own covariance. Wrong weights are worse than none: who knows neither slip nor
/// steer noise gives a guess and lets `unknown_factor` widen it.
struct CalibrationNoise {
  /// Standard deviation of the share by which a segment's way differs from its ticks, [0, 0.1].
  double slip = 5.5e-4;
  /// Of the steering's deviation from what is measured, anew in each segment [rad], [0, 0.1].
  double steer = 1.4e-4;
  /// The greatest slip that all segments of a phase might have in common, beside their own; how
  /// great it is, is told by the spread between the phases; they are few, so intervals get about
  /// twice as wide as without. 0, in both: there is none. [0, 0.1]
  double common_slip = 0.02;
  /// The same of the steering [rad], [0, 0.1].
  double common_steer = 0.01;
  /// Standard deviation of what the laser's motions of a phase have in common, as where reflectors
  /// look displaced from where the phase passes them; no spread tells it apart from the laser's
  /// pose, so it must be known. Position [m], [0, 1], and turn [rad], [0, 1].
  double common_position = 0.0;
  double common_turn = 0.0;
  /// slip and steer may be wrong by up to this factor; what the residuals make of it, decides.
  /// 1: they are known. [1, 16]
  double unknown_factor = 4.0;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibrationNoise& noise);

}  // namespace falko_slam
