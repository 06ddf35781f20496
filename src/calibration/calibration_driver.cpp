// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_driver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr double kThere = 0.003;  // of the wheel's way [m]
constexpr double kCreep = 0.02;   // [m/s]

// Throws before anything moves.
void require_area(const CalibrationPlan& plan, const TricycleParams& tricycle) {
  const double farthest = way_of(plan, tricycle).greatest_distance;
  if (farthest <= plan.max_distance) return;
  throw std::invalid_argument("max_distance = " + fixed_text(plan.max_distance, 2) +
                              ": the arcs lead " + fixed_text(farthest, 2) +
                              " m away from the start: steer more, or find a larger area");
}

}  // namespace

const char* name_of(CalibrationStage stage) {
  switch (stage) {
    case CalibrationStage::kResting:
      return "resting";
    case CalibrationStage::kSteering:
      return "steering";
    case CalibrationStage::kDriving:
      return "driving";
    case CalibrationStage::kHalting:
      return "halting";
    case CalibrationStage::kDone:
      return "done";
    case CalibrationStage::kAborted:
      return "aborted";
  }
  return "?";
}

void validate(const CalibrationDriverParams& params) {
  validate(params.tricycle);
  validate(params.encoders);
  require_in_range("encoder_timeout", params.encoder_timeout, 0.01, 10.0);
  require_in_range("scan_timeout", params.scan_timeout, 0.01, 60.0);
  require_in_range("steering_tolerance", params.steering_tolerance, 1e-5, 0.2);
  require_in_range("motion_timeout", params.motion_timeout, 0.1, 60.0);
  require_in_range("braking", params.braking, 0.01, 10.0);
}

CalibrationDriver::CalibrationDriver(const CalibrationPlan& plan,
                                     const CalibrationDriverParams& params)
    : plan_(plan), params_(params), odometry_(params.tricycle, params.encoders) {
  validate(plan);
  validate(params);
  require_area(plan, params.tricycle);
  arcs_ = arcs_of(plan);
}

std::int32_t CalibrationDriver::add(const EncoderReading& reading) {
  const double before = odometry_.odom_T_base().theta();
  const OdometryStep step = odometry_.add(reading);
  if (step.verdict == OdometryVerdict::kNotLater) return 0;
  last_reading_ = reading.stamp;
  steering_ = steering_of(params_.encoders, reading.steer_ticks);
  last_ticks_ = step.ticks;
  if (step.ticks != 0) moved_ = reading.stamp;
  if (stage_ == CalibrationStage::kDriving || stage_ == CalibrationStage::kHalting) {
    turned_ += angle_between(before, odometry_.odom_T_base().theta());
  }
  return step.ticks;
}

void CalibrationDriver::add_scan(Time stamp, std::size_t seen) {
  if (seen > 0) last_scan_ = last_scan_ ? std::max(*last_scan_, stamp) : stamp;
}

void CalibrationDriver::abort(const std::string& reason) {
  if (stage_ == CalibrationStage::kDone || stage_ == CalibrationStage::kAborted) return;
  stage_ = CalibrationStage::kAborted;
  reason_ = reason;
}

void CalibrationDriver::enter(CalibrationStage stage, Time now) {
  stage_ = stage;
  entered_ = now;
}

void CalibrationDriver::watch(Time now) {
  const auto silent = [&](const std::optional<Time>& last, double timeout) {
    return now - last.value_or(*begin_) > from_seconds(timeout);
  };
  if (silent(last_reading_, params_.encoder_timeout)) return abort("no encoder readings");
  if (silent(last_scan_, params_.scan_timeout)) return abort("no scans that show anything");
  const double distance = odometry_.odom_T_base().translation().norm();
  if (distance > plan_.max_distance) {
    return abort("left the allowed area: " + fixed_text(distance, 2) + " m from the start");
  }
  const bool waits = stage_ == CalibrationStage::kSteering || stage_ == CalibrationStage::kHalting;
  const bool stuck =
      waits ? now - *entered_ > from_seconds(params_.motion_timeout)
            : stage_ == CalibrationStage::kDriving &&
                  now - std::max(*entered_, moved_) > from_seconds(params_.motion_timeout);
  if (stuck) abort(std::string("the vehicle does not obey: ") + name_of(stage_));
}

// Of the wheel, until the arc has turned enough [m].
double CalibrationDriver::remaining_way() const {
  const double radius = params_.tricycle.wheelbase / std::abs(std::sin(arcs_[arc_].steering));
  return (plan_.turn - std::abs(turned_)) * radius;
}

void CalibrationDriver::advance(Time now) {
  const bool halted = last_ticks_ == 0;
  const double steering_error = std::abs(steering_ - arcs_[arc_].steering);
  const Duration since = now - *entered_;
  switch (stage_) {
    case CalibrationStage::kResting:
      if (halted && since >= from_seconds(plan_.rest)) enter(CalibrationStage::kSteering, now);
      break;
    case CalibrationStage::kSteering:
      if (steering_error <= params_.steering_tolerance) {
        turned_ = 0.0;
        enter(CalibrationStage::kDriving, now);
      }
      break;
    case CalibrationStage::kDriving:
      if (remaining_way() <= kThere) enter(CalibrationStage::kHalting, now);
      break;
    case CalibrationStage::kHalting:
      if (halted) {
        ++arc_;
        enter(CalibrationStage::kResting, now);
      }
      break;
    case CalibrationStage::kDone:
    case CalibrationStage::kAborted:
      break;
  }
}

WheelCommand CalibrationDriver::next(Time now) {
  if (!begin_) {
    begin_ = now;
    entered_ = now;
  }
  if (stage_ != CalibrationStage::kDone && stage_ != CalibrationStage::kAborted) watch(now);
  const bool last_rest = stage_ == CalibrationStage::kResting && arc_ == arcs_.size();
  const bool rested = last_ticks_ == 0 && now - *entered_ >= from_seconds(plan_.rest);
  if (last_rest && rested) stage_ = CalibrationStage::kDone;
  if (last_rest || stage_ == CalibrationStage::kAborted || stage_ == CalibrationStage::kDone) {
    return {0.0, steering_};
  }
  advance(now);
  const PlannedArc& arc = arcs_[std::min(arc_, arcs_.size() - 1)];
  switch (stage_) {
    case CalibrationStage::kSteering:
    case CalibrationStage::kHalting:
      return {0.0, arc.steering};
    case CalibrationStage::kDriving: {
      const double softly = std::sqrt(2.0 * params_.braking * std::max(0.0, remaining_way()));
      const double speed = std::clamp(softly, kCreep, std::abs(arc.wheel_speed));
      return {std::copysign(speed, arc.wheel_speed), arc.steering};
    }
    default:
      return {0.0, steering_};
  }
}

CalibrationProgress CalibrationDriver::progress() const {
  CalibrationProgress progress;
  progress.stage = stage_;
  progress.arcs = arcs_.size();
  progress.arc = std::min(arc_, arcs_.size() - 1);
  progress.phase = arcs_[progress.arc].phase;
  double on_arc = stage_ == CalibrationStage::kHalting ? 1.0 : 0.0;
  if (stage_ == CalibrationStage::kDriving) on_arc = std::min(1.0, std::abs(turned_) / plan_.turn);
  progress.fraction =
      std::min(1.0, (static_cast<double>(arc_) + on_arc) / static_cast<double>(arcs_.size()));
  return progress;
}

}  // namespace falko_slam
