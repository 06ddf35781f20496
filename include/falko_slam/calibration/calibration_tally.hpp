// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "falko_slam/calibration/calibrator.hpp"

namespace falko_slam {

/// Of one parameter over many calibrations, in its unit.
struct ParameterStatistics {
  double closed_form_deviation = 0.0;  ///< standard deviation of the closed form
  double deviation = 0.0;              ///< of the maximum likelihood
  double bound = 0.0;                  ///< Cramer-Rao: no unbiased estimate has less; 0: not known
  double bias = 0.0;                   ///< mean of the maximum likelihood minus truth
  double coverage = 0.0;               ///< share of the 95 % intervals that contain the truth
  double half_width = 0.0;             ///< mean of half the intervals' length
};
using CalibrationStatistics = std::array<ParameterStatistics, kCalibrationParameters>;

/// Where a standard deviation of so many runs lies with 95 % probability, as a share of the true
/// one: (runs - 1) s^2 / sigma^2 is chi-square.
struct DeviationScatter {
  double low = 0.0;
  double high = 0.0;
};
DeviationScatter scatter_of_deviation(int runs);

/// Counts many calibrations of one vehicle against the truth. Mean and spread are updated one by
/// one, so nothing is kept but sums.
class CalibrationTally {
 public:
  explicit CalibrationTally(const VehicleCalibration& truth) : truth_(truth) {}

  /// `bound`: the variances that are possible from such segments.
  void add(const CalibrationResult& result,
           const CalibrationVector& bound = CalibrationVector::Zero());

  CalibrationStatistics statistics() const;
  int runs() const { return runs_; }        ///< that gave numbers
  int refused() const { return refused_; }  ///< that gave none
  double outlier_share() const;             ///< of all segments
  double mean_chi2() const;                 ///< per degree of freedom

 private:
  struct Spread {
    CalibrationVector mean = CalibrationVector::Zero(), squares = CalibrationVector::Zero();
    void add(const CalibrationVector& value, double count);
  };

  VehicleCalibration truth_;
  int runs_ = 0, refused_ = 0;
  Spread closed_form_, likeliest_;
  CalibrationVector bounds_ = CalibrationVector::Zero(), covered_ = CalibrationVector::Zero(),
                    widths_ = CalibrationVector::Zero();
  double outliers_ = 0.0, segments_ = 0.0, chi2_ = 0.0;
};

}  // namespace falko_slam
