// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "falko_slam/calibration/segment_recorder.hpp"
#include "falko_slam/simulation/simulation.hpp"

namespace falko_slam {
namespace test {

inline const DriveStep kHalt = WaitStep{1.5};

/// As the vehicle's controller knows it.
inline SegmentRecorderParams recorder_params(const Scenario& scenario) {
  SegmentRecorderParams params;
  params.tricycle = scenario.vehicle.nominal;
  params.base_T_laser = scenario.vehicle.nominal_base_T_laser;
  params.encoders = scenario.vehicle.encoders;
  return params;
}

/// The scenario driven to its end; `observe` gives each scan to the recorder.
template <class Observe>
std::vector<RecordedSegment> recorded(const Scenario& scenario, const SegmentRecorderParams& params,
                                      Observe&& observe) {
  Simulation simulation(scenario, kSimulationStart, 1);
  const auto driver = scenario_driver(scenario.drive, scenario.vehicle);
  SegmentRecorder recorder(params);
  recorder.add(simulation.state().encoders);
  while (const auto input = driver->next(simulation.vehicle(), simulation.period())) {
    const SimulationStep step = simulation.step(*input);
    for (const auto& scan : step.scans) observe(scan, recorder);
    recorder.add(step.encoders);
  }
  recorder.finish();
  return recorder.take();
}

}  // namespace test
}  // namespace falko_slam
