// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/simulation.hpp"

#include "falko_slam/common/random_sequence.hpp"

namespace falko_slam {
namespace {

Scenario checked(Scenario scenario) {
  validate(scenario.vehicle);
  validate(scenario.laser);
  return scenario;
}

}  // namespace

Simulation::Simulation(Scenario scenario, Time start, std::uint64_t seed)
    : scenario_(checked(std::move(scenario))),
      start_(start),
      period_(from_seconds(1.0 / scenario_.vehicle.encoder_rate)),
      vehicle_(scenario_.vehicle, scenario_.world_T_start, start, random_sequence(seed, {1})()),
      scanner_(scenario_.laser, scenario_.vehicle.base_T_laser, scenario_.world, start),
      scan_random_(random_sequence(seed, {2})),
      reflector_diameter_(diameter_of_reflectors(scenario_.world)) {}

Time Simulation::scan_begin() const {
  return start_ + from_seconds(static_cast<double>(scans_) * scenario_.laser.scan_period);
}

SimulationStep Simulation::state() const {
  return {vehicle_.reading(), vehicle_.world_T_base(), {}};
}

SimulationStep Simulation::step(const DriveInput& input) {
  std::visit([&](const auto& motion) { vehicle_.drive(period_, motion); }, input);
  SimulationStep result = state();
  const LaserModel& laser = scenario_.laser;
  const Duration sweep = sweep_of(laser);
  for (; scan_begin() + sweep <= vehicle_.time(); ++scans_) {
    SimulationStep::Scan scan;
    scan.world_T_base = vehicle_.track().at(scan_begin());
    scan.scan = scanner_.scan(scan_begin(), vehicle_.track(), scan_random_);
    scan.reflectors = report_reflectors(laser, scan.scan, reflector_diameter_);
    result.scans.push_back(std::move(scan));
  }
  vehicle_.forget_before(scan_begin());
  return result;
}

}  // namespace falko_slam
