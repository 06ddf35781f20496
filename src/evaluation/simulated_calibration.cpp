// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/simulated_calibration.hpp"

#include <cmath>

#include "falko_slam/calibration/calibration_driver.hpp"
#include "falko_slam/calibration/recorded_calibration.hpp"
#include "falko_slam/common/parallel_work.hpp"
#include "falko_slam/common/random_sequence.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/evaluation/vehicle_knowledge.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kRoom = 3.0;  // beyond what is planned, before the driver aborts [m]

SegmentRecorderParams recorder_params(const SimulatedCalibrationParams& params) {
  SegmentRecorderParams recorder;
  recorder.tricycle = params.vehicle.nominal;
  recorder.base_T_laser = params.vehicle.nominal_base_T_laser;
  recorder.encoders = params.vehicle.encoders;
  recorder.reflectors = params.reflectors;
  recorder.scan_duration = params.laser.scan_period;
  return recorder;
}

}  // namespace

void validate(const SimulatedCalibrationParams& params) {
  validate(params.vehicle);
  validate(params.laser);
  validate(params.hall);
  validate(params.reflectors);
  validate(params.calibrator);
  require_in_range("scans_at_rest", params.scans_at_rest, 2, 200);
  require_in_range("runs", params.runs, 2, 1000000);
  require_in_range("threads", params.threads, 1, 256);
}

ReflectorObservation observation_of(const SimulationStep::Scan& scan) {
  ReflectorObservation observation;
  observation.first_beam = scan.scan.first_beam;
  for (const ReflectorDetection& found : scan.reflectors) {
    observation.reflectors.push_back(
        {found.range * Eigen::Vector2d(std::cos(found.bearing), std::sin(found.bearing)),
         from_seconds(found.time_offset)});
  }
  return observation;
}

SimulatedCalibrationDrive drive_calibration(const Scenario& scenario, const CalibrationPlan& plan,
                                            const SegmentRecorderParams& recorder_params,
                                            std::uint64_t seed) {
  Simulation simulation(scenario, kSimulationStart, seed);
  CalibrationDriverParams driver_params;
  driver_params.tricycle = scenario.vehicle.nominal;
  driver_params.encoders = scenario.vehicle.encoders;
  CalibrationDriver driver(plan, driver_params);
  SegmentRecorder recorder(recorder_params);
  SimulationStep step = simulation.state();
  while (!driver.done() && driver.reason().empty()) {
    for (const SimulationStep::Scan& scan : step.scans) {
      driver.add_scan(scan.scan.first_beam, scan.reflectors.size());
      recorder.add(observation_of(scan));
    }
    driver.add(step.encoders);
    recorder.add(step.encoders);
    step = simulation.step(driver.next(simulation.time()));
  }
  recorder.finish();
  return {recorder.take(), driver.reason(), to_seconds(simulation.time() - kSimulationStart)};
}

// The scans of a halt between two arcs are shared out to both.
CalibrationPlan plan_of(const CalibrationCondition& condition,
                        const SimulatedCalibrationParams& params) {
  CalibrationPlan plan;
  plan.arcs_per_phase = condition.arcs_per_phase;
  plan.min_steering = condition.min_steering;
  plan.max_steering = condition.max_steering;
  plan.turn = condition.turn;
  plan.wheel_speed = condition.wheel_speed;
  plan.rest = SegmentRecorderParams().settling +
              (2.0 * params.scans_at_rest + 1.0) * params.laser.scan_period;
  plan.max_distance = 1000.0;
  plan.max_distance = way_of(plan, params.vehicle.nominal).greatest_distance + kRoom;
  return plan;
}

CalibrationResult calibrate_in_a_hall(const CalibrationPlan& plan,
                                      const SimulatedCalibrationParams& params, std::size_t run) {
  std::mt19937_64 random = random_sequence(params.seed, {static_cast<std::uint32_t>(run)});
  Scenario scenario = random_hall(params.hall, plan, params.vehicle.nominal, random);
  scenario.vehicle = params.vehicle;
  scenario.laser = params.laser;
  const SimulatedCalibrationDrive drive =
      drive_calibration(scenario, plan, recorder_params(params), random());
  if (!drive.trouble.empty()) return {};
  return calibrate_recorded(drive.segments, params.calibrator, params.reflectors.lasting_noise)
      .result;
}

MonteCarloReport run_simulated_calibrations(const CalibrationCondition& condition,
                                            const SimulatedCalibrationParams& params) {
  validate(condition);
  validate(params);
  const CalibrationPlan plan = plan_of(condition, params);
  std::vector<CalibrationResult> results(static_cast<std::size_t>(params.runs));
  do_in_parallel(results.size(), static_cast<std::size_t>(params.threads),
                 [&](std::size_t run) { results[run] = calibrate_in_a_hall(plan, params, run); });
  CalibrationTally tally(true_calibration(params.vehicle));
  for (const CalibrationResult& result : results) tally.add(result);
  return {condition,       tally.statistics(),    tally.runs(),
          tally.refused(), tally.outlier_share(), tally.mean_chi2()};
}

}  // namespace falko_slam
