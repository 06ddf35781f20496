// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "falko_slam/calibration/calibration_tally.hpp"
#include "falko_slam/calibration/calibrator.hpp"

namespace falko_slam {

/// A row of Tables 5.1 and 5.2 of \cite kallasi2017: what is driven in each of the four phases.
struct CalibrationCondition {
  int arcs_per_phase = 4;       ///< n_seg, [1, 1000]
  double min_steering = 0.314;  ///< least |alpha| [rad], (0, pi/2)
  double max_steering = 0.873;  ///< greatest |alpha| [rad], evenly spaced in between
  double turn = 3.142;          ///< beta, of each arc [rad], (0, 4 pi]
  double wheel_speed = 1.0;     ///< v_w [m/s]; of no influence here
};
/// The 20 rows, in their order.
std::vector<CalibrationCondition> thesis_conditions();

/// What is wrong with a simulated drive. What phases have in common is drawn anew for each phase of
/// each calibration.
struct SimulatedCalibrationNoise {
  double detection = 0.007;    ///< standard deviation of a reflector's coordinates [m], (0, 1]
  int scans_at_rest = 1;       ///< detections averaged at each end of an arc, [1, 10000]
  int reflectors = 10;         ///< [2, 10000]
  double min_distance = 8.0;   ///< of reflectors from where an arc begins [m], (0, max_distance]
  double max_distance = 20.0;  ///< [m]
  double slip = 5.5e-4;        ///< standard deviations as in CalibrationNoise
  double steer = 1.4e-4;       ///< [rad]
  double common_slip = 0.0;
  double common_steer = 0.0;  ///< [rad]
  /// A reflector looks displaced by about so much, in a direction that turns twice while one goes
  /// round it; alike in all arcs of a calibration [m], [0, 1].
  double viewpoint_bias = 0.0;
};

struct MonteCarloParams {
  /// A CB16: l and offsets of \cite kallasi2017, Table 5.2, the wheelbase that its tables tell.
  VehicleCalibration truth{
      {1.358, 2.4975e-4, -0.012566, -0.013614}, 1.0, {0.389, 0.0025, 0.007156}};
  SimulatedCalibrationNoise noise;
  CalibratorParams calibrator;  ///< its wheelbase is that of the truth unless told otherwise
  int runs = 400;               ///< [2, 1000000]
  std::uint64_t seed = 1;
  int threads = 1;  ///< [1, 256]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibrationCondition& condition);
void validate(const MonteCarloParams& params);

/// What a calibrator has to be told of the viewpoint bias: by how much the reflectors together
/// displace and turn the laser's motions, alike in all arcs of a phase.
CalibrationNoise told_of_viewpoint_bias(CalibrationNoise told,
                                        const SimulatedCalibrationNoise& simulated);

/// One simulated calibration drive.
std::vector<PathSegment> simulate_calibration_drive(const CalibrationCondition& condition,
                                                    const MonteCarloParams& params,
                                                    std::mt19937_64& random);

struct MonteCarloReport {
  CalibrationCondition condition;
  CalibrationStatistics parameters;
  int runs = 0;              ///< that gave numbers
  int refused = 0;           ///< that gave none
  double outlier_share = 0;  ///< of all segments
  double mean_chi2 = 0.0;    ///< per degree of freedom
};

/// Many simulated calibrations under one condition. The same seed gives the same report, however
/// many threads there are.
MonteCarloReport run_monte_carlo(const CalibrationCondition& condition,
                                 const MonteCarloParams& params);

}  // namespace falko_slam
