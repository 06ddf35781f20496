// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/layout_drive.hpp"

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"
#include "falko_slam/simulation/simulation.hpp"
#include "motion_source.hpp"

namespace falko_slam {
namespace {

constexpr Time kStart{std::chrono::seconds(1)};
constexpr Duration kPatience = std::chrono::seconds(30);  // without a pose
constexpr double kMoves = 0.05;                           // [m/s]

// How well an operator knows where a vehicle stands.
const Eigen::Matrix3d kTold = pose_covariance(0.05, degrees_to_radians(1.0));

LayoutFollowerParams follower_of(const VehicleCalibration& believed, const ActuatorModel& model) {
  LayoutFollowerParams params;
  params.tricycle = believed.tricycle;
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
             std::uint64_t seed)
      : laser_(scenario.laser),
        encoders_(scenario.vehicle.encoders),
        simulation_(scenario, kStart, seed),
        motions_(believed.tricycle, scenario.vehicle.encoders, noise),
        localizer_(mounted(params, believed.base_T_laser), map),
        follower_(follower_of(believed, scenario.vehicle.actuators), layout) {
    localizer_.set_pose(kStart, PoseEstimate{scenario.world_T_start, kTold});
    motions_.add(simulation_.state().encoders);
    motion_.stamp = posed_ = kStart;
  }

  LayoutDrive drive(const std::function<void()>& step) {
    double squares = 0.0;
    std::size_t moves = 0;
    while (!follower_.done() && motion_.stamp - posed_ < kPatience) {
      hear(simulation_.step(follower_.next(motion_)), step);
      look_for_halt();
      if (std::abs(motion_.speed) < kMoves) continue;
      squares += follower_.cross_track() * follower_.cross_track();
      ++moves;
    }
    drive_.cross_track_rmse = moves > 0 ? std::sqrt(squares / static_cast<double>(moves)) : 0.0;
    drive_.seconds = to_seconds(simulation_.time() - kStart);
    if (!follower_.done()) drive_.trouble = trouble();
    return std::move(drive_);
  }

 private:
  void hear(const SimulationStep& now, const std::function<void()>& step) {
    for (const SimulationStep::Scan& scan : now.scans) {
      LaserScan normal;
      normalize(as_raw_scan(laser_, scan.scan), {}, normal);
      const LocalizerReport& report = localizer_.add_scan(normal);
      ++drive_.scans;
      ++drive_.status[static_cast<std::size_t>(report.status)];
      step();
    }
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

  // The follower says so with its next command, before anything moves again.
  void look_for_halt() {
    for (; seen_ < follower_.halts().size(); ++seen_) {
      const Halt& halt = follower_.halts()[seen_];
      if (!halt.name.empty()) drive_.halts.push_back({halt, stood_});
    }
    stood_ = simulation_.vehicle().world_T_base();
  }

  std::string trouble() const {
    const LocalizerReport& report = localizer_.state();
    return std::string("no pose for 30 s: ") + name_of(report.status) + ", " +
           name_of(report.reason);
  }

  LaserModel laser_;
  EncoderParams encoders_;
  Simulation simulation_;
  MotionSource motions_;
  Localizer localizer_;
  LayoutFollower follower_;
  VehicleMotion motion_;
  Time posed_{};
  std::size_t seen_ = 0;
  Pose2 stood_;
  LayoutDrive drive_;
};

}  // namespace

LayoutDrive drive_layout(const Scenario& scenario, const Layout& layout,
                         const VehicleCalibration& believed, LocalizerParams params,
                         const OdometryNoise& noise, const LandmarkMap& map, std::uint64_t seed,
                         const std::function<void()>& step) {
  LedVehicle vehicle(scenario, layout, believed, params, noise, map, seed);
  return vehicle.drive(step);
}

}  // namespace falko_slam
