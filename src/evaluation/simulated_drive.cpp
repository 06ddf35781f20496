// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/simulated_drive.hpp"

#include <random>

#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/simulation/simulation.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"

namespace falko_slam {
namespace {

constexpr Time kStart{std::chrono::seconds(1)};

class Calibration {
 public:
  Calibration(const VehicleModel& truth, const CalibrationSpread& spread, std::mt19937_64& random)
      : tricycle(truth.tricycle) {
    std::normal_distribution<double> error;
    tricycle.steer_offset_forward += spread.steer_offset * error(random);
    tricycle.steer_offset_backward += spread.steer_offset * error(random);
    tricycle.driving_scale += spread.driving_scale * error(random);
    const Pose2& laser = truth.base_T_laser;
    const double x = laser.x() + spread.laser_x * error(random);
    const double y = laser.y() + spread.laser_y * error(random);
    base_T_laser = {x, y, laser.theta() + spread.laser_heading * error(random)};
  }

  TricycleParams tricycle;
  Pose2 base_T_laser;
};

// Turns readings of encoders into motions.
class MotionSource {
 public:
  MotionSource(const Calibration& calibration, const EncoderParams& encoders,
               const OdometryNoise& noise)
      : tricycle_(calibration.tricycle), noise_(noise), odometry_(tricycle_, encoders) {}

  std::optional<DriveInputEvent> add(const EncoderReading& reading) {
    const Pose2 before = odometry_.odom_T_base();
    const OdometryStep step = odometry_.add(reading);
    if (step.verdict != OdometryVerdict::kIntegrated) return std::nullopt;
    const PoseEstimate motion{before.inverse() * odometry_.odom_T_base(),
                              arc_covariance(tricycle_, step.ticks, step.steering, noise_)};
    return DriveInputEvent{reading.stamp, motion, {}};
  }

 private:
  TricycleParams tricycle_;
  OdometryNoise noise_;
  TricycleOdometry odometry_;
};

}  // namespace

SimulatedDrive simulate_drive(const Scenario& scenario, const CalibrationSpread& spread,
                              const OdometryNoise& noise, std::uint64_t seed, double duration,
                              const std::function<void()>& step) {
  std::mt19937_64 random(seed);
  const Calibration calibration(scenario.vehicle, spread, random);
  MotionSource motions(calibration, scenario.vehicle.encoders, noise);
  Simulation simulation(scenario, kStart, seed);
  const auto driver = scenario_driver(scenario.drive, scenario.vehicle);
  SimulatedDrive drive;
  drive.base_T_laser = calibration.base_T_laser;
  const SimulationStep first = simulation.state();
  drive.truth.push_back({simulation.time(), first.world_T_base});
  motions.add(first.encoders);
  while (simulation.time() - kStart < from_seconds(duration)) {
    const auto input = driver->next(simulation.vehicle(), simulation.period());
    if (!input) break;
    const SimulationStep now = simulation.step(*input);
    drive.truth.push_back({simulation.time(), now.world_T_base});
    for (const SimulationStep::Scan& scan : now.scans) {
      LaserScan normal;
      normalize(as_raw_scan(scenario.laser, scan.scan), {}, normal);
      drive.events.push_back({normal.beam_time(normal.size() - 1), {}, std::move(normal)});
      step();
    }
    if (auto motion = motions.add(now.encoders)) drive.events.push_back(std::move(*motion));
  }
  return drive;
}

}  // namespace falko_slam
