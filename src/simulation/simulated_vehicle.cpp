// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/simulated_vehicle.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(1);

double approach(double value, double target, double most) {
  return value + std::clamp(target - value, -most, most);
}

}  // namespace

SimulatedVehicle::SimulatedVehicle(const VehicleModel& model, const Pose2& world_T_base, Time start,
                                   std::uint64_t seed)
    : model_(model), random_(seed), track_(start, world_T_base) {
  validate(model);
  for (int direction = 0; direction < 2; ++direction) {
    for (int side = 0; side < 2; ++side) {
      slip_of_phase_[direction][side] = model.errors.slip_per_phase * normal_(random_);
      steering_of_phase_[direction][side] = model.errors.steering_per_phase * normal_(random_);
    }
  }
}

void SimulatedVehicle::begin_run() {
  slip_of_run_ = model_.errors.slip_per_run * normal_(random_);
  steering_of_run_ = model_.errors.steering_per_run * normal_(random_);
}

// A walk: of a way d its standard deviation is that of a metre times the root of d.
double SimulatedVehicle::white_slip(double way) {
  if (model_.errors.slip_per_root_metre <= 0.0) return 0.0;
  return model_.errors.slip_per_root_metre * std::sqrt(std::abs(way)) * normal_(random_);
}

void SimulatedVehicle::move(Duration duration, double ticks, double steering) {
  if (ticks != 0.0 && stands_) begin_run();
  stands_ = ticks == 0.0;
  const double middle = 0.5 * (steering_ + steering);
  steering_ = steering;
  ticks_ += ticks;
  if (stands_) return track_.add(duration, Eigen::Vector3d::Zero());
  const int direction = ticks > 0.0 ? 1 : 0;
  const int side = middle > 0.0 ? 1 : 0;
  const TricycleParams& tricycle = model_.tricycle;
  const double slip = slip_of_run_ + slip_of_phase_[direction][side];
  const double wheel = tricycle.driving_scale * ticks;
  const double way = wheel * (1.0 + slip) + white_slip(wheel);
  const double angle = true_steering(tricycle, middle, ticks) + steering_of_run_ +
                       steering_of_phase_[direction][side];
  track_.add(duration, {way * std::cos(angle), 0.0, way * std::sin(angle) / tricycle.wheelbase});
}

void SimulatedVehicle::drive(Duration duration, const WheelCommand& command) {
  const ActuatorModel& limits = model_.actuators;
  const double wanted_speed =
      std::clamp(command.wheel_speed, -limits.max_wheel_speed, limits.max_wheel_speed);
  const double wanted_steering =
      std::clamp(command.steering, -limits.max_steering, limits.max_steering);
  for (Duration left = duration; left > Duration::zero(); left -= kStep) {
    const Duration step = std::min(kStep, left);
    const double seconds = to_seconds(step);
    const double speed = approach(wheel_speed_, wanted_speed, limits.acceleration * seconds);
    const double mean_speed = 0.5 * (wheel_speed_ + speed);
    wheel_speed_ = speed;
    move(step, mean_speed * seconds / model_.nominal.driving_scale,
         approach(steering_, wanted_steering, limits.steer_rate * seconds));
  }
}

void SimulatedVehicle::drive(Duration duration, const EncoderMotion& motion) {
  const double seconds = to_seconds(duration);
  if (seconds <= 0.0) return;
  wheel_speed_ = motion.ticks * model_.nominal.driving_scale / seconds;
  const double turn = motion.steering - steering_;
  const double steering_begin = steering_;
  Duration done{};
  for (Duration left = duration; left > Duration::zero(); left -= kStep) {
    const Duration step = std::min(kStep, left);
    done += step;
    move(step, motion.ticks * to_seconds(step) / seconds,
         steering_begin + turn * to_seconds(done) / seconds);
  }
}

EncoderReading SimulatedVehicle::reading() const {
  constexpr double kRounding = 1e-6;  // of many small steps
  const auto counted = static_cast<std::int64_t>(std::floor(ticks_ + kRounding));
  return {time(), model_.first_drive_ticks + static_cast<std::uint32_t>(counted),
          steer_ticks_of(model_.encoders, steering_)};
}

}  // namespace falko_slam
