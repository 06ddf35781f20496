// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "falko_slam/calibration/calibration_noise.hpp"
#include "falko_slam/calibration/path_segment.hpp"
#include "falko_slam/calibration/vehicle_calibration.hpp"

namespace falko_slam {

/// What the wheel did on one arc, as the encoders say.
struct ArcControl {
  double ticks = 0.0;
  double steering = 0.0;  ///< [rad]
};

/// One measurement of the laser's motion along arcs: of a path segment, or of a window of a drive.
struct MeasuredStretch {
  std::vector<ArcControl> arcs;
  Eigen::Vector3d motion;      ///< (x, y, turn with its whole turns) of the laser at the end, seen
                               ///< from where it was at the start
  Eigen::Matrix3d covariance;  ///< of motion as measured
  /// With the motion of the next stretch; columns: the next one.
  Eigen::Matrix3d covariance_with_next = Eigen::Matrix3d::Zero();
};
MeasuredStretch stretch_of(const PathSegment& segment);

/// The motion that a calibration expects, s = l^-1 r l, and its derivatives.
struct StretchPrediction {
  Eigen::Vector3d motion;
  Eigen::Matrix<double, 3, kCalibrationParameters> dparameters;
  Eigen::Vector3d dslip, dsteer;  ///< by the two of EncoderError
};
StretchPrediction predict(const VehicleCalibration& calibration,
                          const std::vector<ArcControl>& arcs, const EncoderError& error = {});

}  // namespace falko_slam
