// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/simulation/layout_follower.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "path_tracking.hpp"

namespace falko_slam {
namespace {

constexpr double kStands = 1e-3;                             // [m/s]
constexpr double kSteered = 0.05;                            // off by less: at full speed [rad]
constexpr double kSteeredNot = 0.25;                         // by more: the wheel steers at rest
constexpr Duration kStood = std::chrono::milliseconds(100);  // before it counts as a halt

}  // namespace

void validate(const LayoutFollowerParams& params) {
  validate(params.tricycle);
  require_in_range("steer_gain", params.steer_gain, 0.01, 100.0);
  require_in_range("acceleration", params.acceleration, 1e-3, 10.0);
  require_in_range("max_steering", params.max_steering, 1e-3, 1.5);
  require_in_range("response", params.response, 0.05, 10.0);
  require_in_range("response_time", params.response_time, 0.0, 10.0);
  require_in_range("max_sideways", params.max_sideways, 1e-3, 10.0);
}

class LayoutFollower::Impl {
 public:
  Impl(const LayoutFollowerParams& params, Layout layout)
      : params_(params), layout_(std::move(layout)) {
    validate(params);
    if (layout_.steps.empty()) throw std::invalid_argument("layout: it has no steps");
  }

  WheelCommand next(const PosedMotion& motion) {
    remember_motion(motion);
    while (!done()) {
      const LayoutStep& step = layout_.steps[step_];
      const auto* wait = std::get_if<WaitStep>(&step);
      const auto command =
          wait != nullptr ? await(*wait, motion) : follow(std::get<FollowStep>(step), motion);
      if (command) return *command;
      ++step_;
      step_begin_.reset();
      tracking_.reset();
    }
    return halt();
  }

  void begin_again() {
    step_ = 0;
    step_begin_.reset();
    tracking_.reset();
    halts_.clear();
  }

  bool done() const { return step_ == layout_.steps.size(); }
  const std::vector<Halt>& halts() const { return halts_; }
  double cross_track() const { return tracking_ ? tracking_->cross_track() : 0.0; }

 private:
  WheelCommand halt() const { return {0.0, steering_}; }

  void remember_motion(const PosedMotion& motion) {
    if (std::abs(motion.speed) > kStands || !stands_since_) stands_since_ = motion.stamp;
  }

  std::optional<WheelCommand> await(const WaitStep& wait, const PosedMotion& motion) {
    if (!step_begin_) step_begin_ = motion.stamp;
    if (motion.stamp - *step_begin_ >= from_seconds(wait.seconds)) return std::nullopt;
    return halt();
  }

  std::optional<WheelCommand> follow(const FollowStep& step, const PosedMotion& motion) {
    if (!motion.map_T_base) return halt();
    if (!tracking_) begin_path(step, motion);
    tracking_->move_to(*motion.map_T_base);
    const double speed = std::abs(motion.speed);
    const bool there = tracking_->remaining() <= 0.5 * speed * speed / params_.acceleration;
    arrived_ = arrived_ || there;
    if (!arrived_) return along(step, motion);
    if (motion.stamp - *stands_since_ < kStood) return halt();
    halts_.push_back({step.name, motion.stamp, tracking_->map_T_end(), *motion.map_T_base,
                      tracking_->ends_in_curve()});
    return std::nullopt;
  }

  void begin_path(const FollowStep& step, const PosedMotion& motion) {
    const Eigen::Vector2d begin = path_end_.value_or(motion.map_T_base->translation());
    tracking_.emplace(step, params_, begin);
    path_end_ = tracking_->map_T_end().translation();
    arrived_ = false;
  }

  // The wheel goes farther than the rear axle, and its offset is in what it is told.
  WheelCommand along(const FollowStep& step, const PosedMotion& motion) {
    const double curvature = tracking_->curvature(std::abs(motion.speed));
    const double wanted = std::atan(params_.tricycle.wheelbase * curvature);
    const double angle = std::clamp(wanted, -params_.max_steering, params_.max_steering);
    const double direction = step.backward ? -1.0 : 1.0;
    steering_ = (angle - true_steering(params_.tricycle, 0.0, direction)) / params_.steer_gain;
    const double error = std::abs(steering_ - motion.steering.value_or(steering_));
    const double ready = std::clamp((kSteeredNot - error) / (kSteeredNot - kSteered), 0.0, 1.0);
    const double speed = std::min(step.speed, tracking_->speed_limit() / std::cos(angle));
    return {direction * ready * speed, steering_};
  }

  LayoutFollowerParams params_;
  Layout layout_;
  std::size_t step_ = 0;
  std::optional<Time> step_begin_, stands_since_;
  std::optional<PathTracking> tracking_;
  std::optional<Eigen::Vector2d> path_end_;  // of the path before
  bool arrived_ = false;
  double steering_ = 0.0;  // as last commanded
  std::vector<Halt> halts_;
};

LayoutFollower::LayoutFollower(const LayoutFollowerParams& params, Layout layout)
    : impl_(std::make_unique<Impl>(params, std::move(layout))) {}
LayoutFollower::~LayoutFollower() = default;
LayoutFollower::LayoutFollower(LayoutFollower&&) noexcept = default;
LayoutFollower& LayoutFollower::operator=(LayoutFollower&&) noexcept = default;

WheelCommand LayoutFollower::next(const PosedMotion& motion) { return impl_->next(motion); }
bool LayoutFollower::done() const { return impl_->done(); }
void LayoutFollower::begin_again() { impl_->begin_again(); }
const std::vector<Halt>& LayoutFollower::halts() const { return impl_->halts(); }
double LayoutFollower::cross_track() const { return impl_->cross_track(); }

}  // namespace falko_slam
