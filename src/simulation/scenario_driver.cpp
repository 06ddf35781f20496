// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/simulation/driver.hpp"
#include "path_follower.hpp"

namespace falko_slam {
namespace {

constexpr double kSamePlace = 1e-6;  // [m]

/// A wait: over when its time is.
class Wait {
 public:
  Wait(const WaitStep& step, const SimulatedVehicle& vehicle)
      : end_(vehicle.time() + from_seconds(step.seconds)) {}
  std::optional<WheelCommand> next(const SimulatedVehicle& vehicle) const {
    if (vehicle.time() >= end_) return std::nullopt;
    return WheelCommand{0.0, vehicle.steering()};
  }

 private:
  Time end_;
};

/// An arc: steered to at rest, then driven until it is long enough, then braked.
class Arc {
 public:
  Arc(const ArcStep& step, const VehicleModel& vehicle, const SimulatedVehicle& at)
      : step_(step), model_(vehicle), last_(at.world_T_base()) {
    const double most = vehicle.actuators.max_steering;
    step_.steering = std::clamp(step.steering, -most, most);
  }

  std::optional<WheelCommand> next(const SimulatedVehicle& vehicle) {
    advance(vehicle.world_T_base());
    const double remaining = remaining_way();
    if (remaining <= kThere) {
      if (vehicle.wheel_speed() == 0.0) return std::nullopt;
      return WheelCommand{0.0, step_.steering};
    }
    const bool steered = std::abs(vehicle.steering() - step_.steering) < 1e-9;
    if (!steered && way_ < kSamePlace) return WheelCommand{0.0, step_.steering};
    const double speed = std::min(std::abs(step_.wheel_speed),
                                  braking_speed(remaining, model_.actuators.acceleration));
    return WheelCommand{std::copysign(speed, step_.wheel_speed), step_.steering};
  }

 private:
  void advance(const Pose2& world_T_base) {
    const Pose2 step = last_.inverse() * world_T_base;
    last_ = world_T_base;
    const double wheel = model_.tricycle.wheelbase * step.theta();
    way_ += std::hypot(step.translation().norm(), wheel);
    turned_ += step.theta();
  }

  // Of the wheel [m].
  double remaining_way() const {
    double remaining = std::numeric_limits<double>::infinity();
    if (step_.way > 0.0) remaining = step_.way - way_;
    if (step_.turn > 0.0) {
      const double radius = model_.tricycle.wheelbase / std::abs(std::sin(step_.steering));
      remaining = std::min(remaining, (step_.turn - std::abs(turned_)) * radius);
    }
    return remaining;
  }

  ArcStep step_;
  VehicleModel model_;
  Pose2 last_;
  double way_ = 0.0;     // of the wheel [m]
  double turned_ = 0.0;  // not wrapped [rad]
};

class ScenarioDriver : public Driver {
 public:
  ScenarioDriver(std::vector<DriveStep> steps, const VehicleModel& model)
      : steps_(std::move(steps)), model_(model) {}

  std::optional<DriveInput> next(const SimulatedVehicle& vehicle, Duration) override {
    while (done_ < steps_.size()) {
      if (!running_) begin(steps_[done_], vehicle);
      const auto command =
          std::visit([&](auto& maneuver) { return maneuver.next(vehicle); }, *running_);
      if (command) return DriveInput(*command);
      running_.reset();
      ++done_;
    }
    return std::nullopt;
  }

 private:
  void begin(const DriveStep& step, const SimulatedVehicle& vehicle) {
    if (const auto* wait = std::get_if<WaitStep>(&step)) running_.emplace(Wait(*wait, vehicle));
    if (const auto* arc = std::get_if<ArcStep>(&step)) running_.emplace(Arc(*arc, model_, vehicle));
    if (const auto* follow = std::get_if<FollowStep>(&step)) {
      running_.emplace(PathFollower(*follow, model_, vehicle.world_T_base()));
    }
  }

  std::vector<DriveStep> steps_;
  VehicleModel model_;
  std::size_t done_ = 0;
  std::optional<std::variant<Wait, Arc, PathFollower>> running_;
};

}  // namespace

std::unique_ptr<Driver> scenario_driver(std::vector<DriveStep> steps, const VehicleModel& vehicle) {
  return std::make_unique<ScenarioDriver>(std::move(steps), vehicle);
}

}  // namespace falko_slam
