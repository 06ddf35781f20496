// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/calibration/vehicle_calibration.hpp"

namespace falko_slam {

/// What repeated calibrations of a real CB16 gave. [rad], [m/tick], [m]; nothing of wheelbase and
/// steer gain.
struct PublishedCalibration {
  CalibrationVector mean = CalibrationVector::Zero();
  CalibrationVector deviation = CalibrationVector::Zero();
};

/// A row of \cite kallasi2017, Tables 5.1 and 5.2. Each is of three or four calibrations, so a
/// deviation is good to about half of itself; those of Table 5.1 are divided by n, those of Table
/// 5.2 by n - 1.
struct ThesisCalibration {
  PublishedCalibration standard;    ///< Table 5.1; alpha_off stands for both offsets
  PublishedCalibration asymmetric;  ///< Table 5.2

  const PublishedCalibration& of(TricycleModel model) const {
    return model == TricycleModel::kStandard ? standard : asymmetric;
  }
};

/// The 20 rows, in the order of thesis_conditions().
std::vector<ThesisCalibration> thesis_calibrations();

/// What a parameter is multiplied with to stand in those tables as here: cdeg, 1e-5 mm/tick, mm.
double thesis_unit(CalibrationParameter parameter);

}  // namespace falko_slam
