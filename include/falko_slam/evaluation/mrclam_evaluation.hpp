// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "falko_slam/localization/association.hpp"
#include "falko_slam/sensor/mrclam_log.hpp"

namespace falko_slam {

/// What the filter believes of a robot of \cite leung2011: a unicycle whose motion between two
/// commands is an arc.
struct MrclamParams {
  double way_noise = 0.02;      ///< of the way, grows with its root [m / sqrt(m)], [0, 10]
  double turn_noise = 0.2;      ///< of the turn, grows with its root [rad / sqrt(rad)], [0, 10]
  double heading_drift = 0.02;  ///< of the heading while it moves [rad / sqrt(s)], [0, 10]
  double turn_scale = 1.0;      ///< true turn over commanded turn, (0, 10]
  double range_noise = 0.1;     ///< [m], (0, 10]
  double bearing_noise = 0.02;  ///< [rad], (0, 10]
  /// Errors of one landmark's observations die out like exp(-t / correlation_time): each counts for
  /// less where the one before is not long ago. 0: all are new [s], [0, 1000]
  double correlation_time = 0.0;
  bool use_ids = true;  ///< false: barcodes are not looked at, the filter associates
  AssociationParams association;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const MrclamParams& params);

struct PoseRmse {
  double position = 0.0;  ///< [m]
  double heading = 0.0;   ///< [rad]
};

struct MrclamEvaluation {
  PoseRmse filter, odometry;                           ///< odometry from the true first pose on
  double median_position = 0.0, median_heading = 0.0;  ///< of the filter's errors [m], [rad]
  std::size_t updates = 0;
  std::size_t observations = 0, used = 0;
  std::size_t wrong = 0;     ///< used, but for another landmark than the barcode says
  double mean_nis = 0.0;     ///< per degree of freedom, ideal 1
  double nis_inside = 0.0;   ///< share of updates within the two-sided 95 % bounds of their NIS
  double mean_nees = 0.0;    ///< per degree of freedom, once a second
  double median_nees = 0.0;  ///< ideal 0.79
  double nees_inside = 0.0;  ///< share within the two-sided 95 % bounds
};

/// PoseFilter on a run, from the true first pose on, against the truth.
/// Throws std::runtime_error if there is no odometry or no truth at its beginning.
MrclamEvaluation evaluate_mrclam(const MrclamRun& run, const MrclamParams& params);

}  // namespace falko_slam
