// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/simulated_drive.hpp"

#include <memory>
#include <random>
#include <utility>
#include <variant>

#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/simulation/simulation.hpp"
#include "motion_source.hpp"

namespace falko_slam {
namespace {

// The steps of a scenario one by one, each named one a leg.
class StepDriver {
 public:
  explicit StepDriver(const Scenario& scenario) : scenario_(scenario) {}

  std::optional<DriveInput> next(const Simulation& simulation, std::vector<DriveLeg>& legs) {
    const SimulatedVehicle& vehicle = simulation.vehicle();
    if (leg_) follow_leg(simulation, legs.back());
    while (true) {
      if (driver_) {
        if (const auto input = driver_->next(vehicle, simulation.period())) return input;
      }
      if (next_ == scenario_.drive.size()) return std::nullopt;
      const DriveStep& step = scenario_.drive[next_++];
      driver_ = scenario_driver({step}, scenario_.vehicle);
      begin_leg(step, simulation, legs);
    }
  }

 private:
  void begin_leg(const DriveStep& step, const Simulation& simulation, std::vector<DriveLeg>& legs) {
    const auto* follow = std::get_if<FollowStep>(&step);
    leg_ = follow != nullptr && !follow->name.empty();
    if (!leg_) return;
    legs.push_back({follow->name, simulation.time(), simulation.time(), simulation.time()});
    until_ = follow->reflectors_until;
    last_ = simulation.vehicle().world_T_base().translation();
    way_ = 0.0;
  }

  void follow_leg(const Simulation& simulation, DriveLeg& leg) {
    const Eigen::Vector2d now = simulation.vehicle().world_T_base().translation();
    way_ += (now - last_).norm();
    last_ = now;
    leg.end = simulation.time();
    if (way_ <= until_) leg.reflectors_until = leg.end;
  }

  const Scenario& scenario_;
  std::size_t next_ = 0;
  std::unique_ptr<Driver> driver_;
  bool leg_ = false;
  double until_ = 0.0, way_ = 0.0;
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
};

}  // namespace

SimulatedDrive simulate_drive(const Scenario& scenario, const CalibrationSpread& spread,
                              const OdometryNoise& noise, std::uint64_t seed, double duration,
                              const std::function<void()>& step) {
  std::mt19937_64 random(seed);
  const VehicleCalibration calibration = drawn_calibration(scenario.vehicle, spread, random);
  MotionSource motions(calibration.tricycle, scenario.vehicle.encoders, noise);
  Simulation simulation(scenario, kSimulationStart, seed);
  SimulatedDrive drive;
  drive.base_T_laser = calibration.base_T_laser;
  const SimulationStep first = simulation.state();
  drive.truth.push_back({simulation.time(), first.world_T_base});
  motions.add(first.encoders);
  StepDriver driver(scenario);
  while (simulation.time() - kSimulationStart < from_seconds(duration)) {
    const auto input = driver.next(simulation, drive.legs);
    if (!input) break;
    const SimulationStep now = simulation.step(*input);
    drive.truth.push_back({simulation.time(), now.world_T_base});
    for (const SimulationStep::Scan& scan : now.scans) {
      LaserScan normal;
      normalize(as_raw_scan(scenario.laser, scan.scan), {}, normal);
      drive.events.push_back({normal.beam_time(normal.size() - 1), {}, std::move(normal)});
      step();
    }
    if (const auto motion = motions.add(now.encoders)) {
      drive.events.push_back({now.encoders.stamp, *motion, {}});
    }
  }
  return drive;
}

}  // namespace falko_slam
