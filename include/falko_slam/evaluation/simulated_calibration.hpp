// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "falko_slam/calibration/calibration_plan.hpp"
#include "falko_slam/calibration/monte_carlo.hpp"
#include "falko_slam/calibration/segment_recorder.hpp"
#include "falko_slam/simulation/simulation.hpp"

namespace falko_slam {

/// How halls are drawn: reflectors all around where a calibration drives, plain walls beyond.
struct RandomHallParams {
  int min_reflectors = 8;      ///< [3, max_reflectors]
  int max_reflectors = 20;     ///< [min_reflectors, 1000]
  double min_distance = 8.0;   ///< of a reflector from the middle of the drive [m], [1, 100]
  double max_distance = 20.0;  ///< [m], [min_distance, 100]
  double clearance = 1.0;      ///< between reflectors and the way of base_link [m], [0, 10]
  double min_wall_gap = 2.0;   ///< from the farthest possible reflector to a wall [m], [0.1, 100]
  double max_wall_gap = 12.0;  ///< [m], [min_wall_gap, 100]
  double reflector_radius = 0.04;  ///< [m], [0.005, 0.5]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const RandomHallParams& params);

/// World and start of a calibration drive; the heading is drawn, too. Vehicle and laser are the
/// default ones. Throws std::invalid_argument if there is no room for reflectors beside the way.
Scenario random_hall(const RandomHallParams& params, const CalibrationPlan& plan,
                     const TricycleParams& tricycle, std::mt19937_64& random);

/// The reflectors of a simulated scan as a device reports them.
ReflectorObservation observation_of(const SimulationStep::Scan& scan);

/// What a recorder makes of a simulated drive.
struct SimulatedCalibrationDrive {
  std::vector<RecordedSegment> segments;
  std::string trouble;   ///< why the driver aborted; empty: it did not
  double seconds = 0.0;  ///< of the vehicle's time
};

/// The whole chain but the calibrator: a CalibrationDriver leads the simulated vehicle by encoders
/// and reflectors, a SegmentRecorder listens. The same arguments give the same result.
SimulatedCalibrationDrive drive_calibration(const Scenario& scenario, const CalibrationPlan& plan,
                                            const SegmentRecorderParams& recorder,
                                            std::uint64_t seed);

/// Calibrations in the complete simulator, each in a hall of its own.
struct SimulatedCalibrationParams {
  VehicleModel vehicle;  ///< its `errors` are those of the drives
  LaserModel laser;
  RandomHallParams hall;
  ReflectorMotionParams reflectors;  ///< what the recorder believes of them
  CalibratorParams calibrator;
  int scans_at_rest = 20;  ///< averaged at each end of an arc, at least, [2, 200]
  int runs = 20;           ///< [2, 1000000]
  std::uint64_t seed = 1;
  int threads = 1;  ///< [1, 256]
};
/// Throws std::invalid_argument with the field and its value.
void validate(const SimulatedCalibrationParams& params);

/// The plan that drives a condition and rests long enough for that many scans.
CalibrationPlan plan_of(const CalibrationCondition& condition,
                        const SimulatedCalibrationParams& params);

/// One of them, the run of this number: another hall, other noise. UNOBSERVABLE if the drive was
/// aborted.
CalibrationResult calibrate_in_a_hall(const CalibrationPlan& plan,
                                      const SimulatedCalibrationParams& params, std::size_t run);

/// Many calibrations under one condition; drives that were aborted count as refused, bounds are not
/// known. The same seed gives the same report, however many threads there are.
MonteCarloReport run_simulated_calibrations(const CalibrationCondition& condition,
                                            const SimulatedCalibrationParams& params);

}  // namespace falko_slam
