// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "falko_slam/calibration/calibration_noise.hpp"
#include "segment_model.hpp"

namespace falko_slam {

/// The directions in which a calibration may move: calibration = start + columns * x. Columns are
/// scaled so that x is of one size; in the standard model one column moves both offsets.
struct FreeParameters {
  Eigen::Matrix<double, kCalibrationParameters, Eigen::Dynamic> columns;

  Eigen::Index count() const { return columns.cols(); }
};
struct FreeChoice {
  TricycleModel model = TricycleModel::kAsymmetric;
  bool wheelbase = false;
  bool steer_gain = false;
};
FreeParameters free_parameters(const FreeChoice& choice, const VehicleCalibration& start);

/// What is fitted to: stretches, which of them have errors in common, and what is left out.
struct StretchSet {
  std::vector<MeasuredStretch> stretches;
  std::vector<std::size_t> phases;  ///< of each stretch, below kDrivePhases
  std::vector<bool> used;
};

/// Covariance of a stretch's residual: as measured, and by the errors of the encoders to first
/// order.
Eigen::Matrix3d residual_covariance(const MeasuredStretch& stretch,
                                    const StretchPrediction& prediction,
                                    const CalibrationNoise& noise);

struct StretchFit {
  VehicleCalibration calibration;
  std::array<EncoderError, kDrivePhases> common;  ///< of each phase
  bool converged = false;
  int iterations = 0;
};

enum class FitLoss { kNone, kCauchy };

/// The most likely calibration: the errors of the single stretches are propagated into their
/// covariance at the current estimate, and that anew until nothing changes; what a phase has in
/// common are variables with a prior (common_slip, common_steer) of their own.
StretchFit fit(const StretchSet& set, const FreeParameters& free, const VehicleCalibration& start,
               const CalibrationNoise& noise, FitLoss loss);

}  // namespace falko_slam
