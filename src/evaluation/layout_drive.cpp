// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/layout_drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/simulation/simulation.hpp"
#include "motion_source.hpp"

namespace falko_slam {
namespace {

constexpr Duration kPatience = std::chrono::seconds(30);  // without a pose
constexpr double kMoves = 0.05;                           // [m/s]

// How well an operator knows where a vehicle stands.
const Eigen::Matrix3d kTold = pose_covariance(0.05, degrees_to_radians(1.0));

LayoutFollowerParams follower_of(const VehicleCalibration& believed, const ActuatorModel& model) {
  LayoutFollowerParams params;
  params.tricycle = believed.tricycle;
  params.steer_gain = believed.steer_gain;
  params.acceleration = model.acceleration;
  params.max_steering = std::min(params.max_steering, model.max_steering);
  return params;
}

LocalizerParams mounted(LocalizerParams params, const Pose2& base_T_laser) {
  params.base_T_laser = base_T_laser;
  return params;
}

class LedVehicle {
 public:
  LedVehicle(const Scenario& scenario, const Layout& layout, const VehicleCalibration& believed,
             const LocalizerParams& params, const OdometryNoise& noise, const LandmarkMap& map,
             std::uint64_t seed, const std::function<void(const LayoutScan&)>& observe,
             const std::function<void(const HaltingPoint&)>& halted)
      : observe_(observe),
        halted_(halted),
        laser_(scenario.laser),
        encoders_(scenario.vehicle.encoders),
        simulation_(scenario, kSimulationStart, seed),
        motions_(believed.tricycle, scenario.vehicle.encoders, noise),
        localizer_(mounted(params, believed.base_T_laser), map),
        follower_(follower_of(believed, scenario.vehicle.actuators), layout) {
    localizer_.set_pose(kSimulationStart, PoseEstimate{scenario.world_T_start, kTold});
    motions_.add(simulation_.state().encoders);
    motion_.stamp = posed_ = kSimulationStart;
    before_ = scenario.world_T_start;
  }

  LayoutDrive drive(const LayoutRepetition& repetition) {
    const Time end = kSimulationStart + from_seconds(repetition.most_seconds);
    for (int round = 0; round < repetition.rounds && !lost(); ++round) {
      follower_.begin_again();
      seen_ = 0;
      while (!follower_.done() && !lost() && simulation_.time() < end) step();
    }
    drive_.cross_track_rmse = moves_ > 0 ? std::sqrt(squares_ / static_cast<double>(moves_)) : 0.0;
    drive_.seconds = to_seconds(simulation_.time() - kSimulationStart);
    if (lost()) drive_.trouble = trouble();
    return std::move(drive_);
  }

 private:
  bool lost() const { return motion_.stamp - posed_ >= kPatience; }

  void step() {
    const WheelCommand command = follower_.next(motion_);
    look_for_halt();
    hear(simulation_.step(command));
    if (std::abs(motion_.speed) < kMoves) return;
    squares_ += follower_.cross_track() * follower_.cross_track();
    ++moves_;
  }

  void hear(const SimulationStep& now) {
    for (const SimulationStep::Scan& scan : now.scans) {
      LaserScan normal;
      normalize(as_raw_scan(laser_, scan.scan), {}, normal);
      const auto begin = std::chrono::steady_clock::now();
      const LocalizerReport& report = localizer_.add_scan(normal);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
      ++drive_.scans;
      ++drive_.status[static_cast<std::size_t>(report.status)];
      observe_({report, before_, took.count()});
    }
    before_ = now.world_T_base;
    const auto moved = motions_.add(now.encoders);
    if (!moved) return;
    const double seconds = to_seconds(now.encoders.stamp - motion_.stamp);
    localizer_.add_motion(now.encoders.stamp, *moved);
    motion_ = {now.encoders.stamp,
               {},
               moved->pose.x() / seconds,
               steering_of(encoders_, now.encoders.steer_ticks)};
    if (!localizer_.state().map_T_base) return;
    motion_.map_T_base = localizer_.state().map_T_base->pose;
    posed_ = motion_.stamp;
  }

  // The vehicle still stands when its follower says so.
  void look_for_halt() {
    for (; seen_ < follower_.halts().size(); ++seen_) {
      const Halt& halt = follower_.halts()[seen_];
      if (halt.name.empty()) continue;
      drive_.halts.push_back({halt, before_});
      halted_(drive_.halts.back());
    }
  }

  std::string trouble() const {
    const LocalizerReport& report = localizer_.state();
    return std::string("no pose for 30 s: ") + name_of(report.status) + ", " +
           name_of(report.reason);
  }

  const std::function<void(const LayoutScan&)>& observe_;
  const std::function<void(const HaltingPoint&)>& halted_;
  LaserModel laser_;
  EncoderParams encoders_;
  Simulation simulation_;
  MotionSource motions_;
  Localizer localizer_;
  LayoutFollower follower_;
  PosedMotion motion_;
  Time posed_{};
  std::size_t seen_ = 0;
  Pose2 before_;  // the truth when the last motion ended
  double squares_ = 0.0;
  std::size_t moves_ = 0;
  LayoutDrive drive_;
};

}  // namespace

LayoutDrive drive_layout(const Scenario& scenario, const Layout& layout,
                         const VehicleCalibration& believed, const LocalizerParams& params,
                         const OdometryNoise& noise, const LandmarkMap& map, std::uint64_t seed,
                         const LayoutRepetition& repetition,
                         const std::function<void(const LayoutScan&)>& observe,
                         const std::function<void(const HaltingPoint&)>& halted) {
  LedVehicle vehicle(scenario, layout, believed, params, noise, map, seed, observe, halted);
  return vehicle.drive(repetition);
}

}  // namespace falko_slam
