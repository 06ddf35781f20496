// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/segment_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

constexpr Duration kRemembered = std::chrono::seconds(10);  // of the encoders

}  // namespace

void validate(const SegmentRecorderParams& params) {
  validate(params.tricycle);
  validate(params.encoders);
  validate(params.reflectors);
  require_in_range("scan_duration", params.scan_duration, 0.0, 10.0);
  require_in_range("settling", params.settling, 0.0, 60.0);
  require_in_range<std::size_t>("min_scans_at_rest", params.min_scans_at_rest, 1, 10000);
  require_in_range("min_way", params.min_way, 0.0, 1000.0);
  require_in_range("max_steering_change", params.max_steering_change, 0.0, kPi);
}

SegmentRecorder::SegmentRecorder(const SegmentRecorderParams& params)
    : params_(params), odometry_(params.tricycle, params.encoders) {
  validate(params);
}

void SegmentRecorder::add(const EncoderReading& reading) {
  const auto last = odometry_.reading();
  const OdometryStep step = odometry_.add(reading);
  if (step.verdict == OdometryVerdict::kNotLater) return;
  Instant now{reading.stamp, odometry_.odom_T_base() * params_.base_T_laser, 0,
              steering_of(params_.encoders, reading.steer_ticks)};
  if (last && !instants_.empty()) {
    const Instant& before = instants_.back();
    now.ticks = before.ticks + step.ticks;
    now.steering = before.steering +
                   steering_between(params_.encoders, last->steer_ticks, reading.steer_ticks);
    now.moving = step.ticks != 0;
    if (now.moving) {
      use_waiting();
      if (at_rest()) begin_way(before);
      extend_way(before, now);
    } else if (way_ && !way_->halted && now.stamp - way_->end >= from_seconds(params_.settling)) {
      way_->halted = true;
      halted_since_ = way_->end;
    }
  } else {
    halted_since_ = reading.stamp;
  }
  instants_.push_back(now);
  while (instants_.size() > 2 && now.stamp - instants_[1].stamp > kRemembered) {
    instants_.pop_front();
  }
  use_waiting();
}

void SegmentRecorder::add(const ReflectorObservation& observation) {
  waiting_.push_back(observation);
  use_waiting();
}

// Those whose last beam is not later than the last reading.
void SegmentRecorder::use_waiting() {
  const Duration duration = from_seconds(params_.scan_duration);
  while (!waiting_.empty() && !instants_.empty() &&
         waiting_.front().first_beam + duration <= instants_.back().stamp) {
    use(waiting_.front());
    waiting_.pop_front();
  }
}

std::optional<SegmentRecorder::Instant> SegmentRecorder::at(Time time) const {
  const auto after =
      std::lower_bound(instants_.begin(), instants_.end(), time,
                       [](const Instant& instant, Time t) { return instant.stamp < t; });
  if (after == instants_.end() || (after == instants_.begin() && after->stamp > time)) {
    return std::nullopt;
  }
  if (after->stamp == time) return *after;
  const Instant& before = *std::prev(after);
  const double share = to_seconds(time - before.stamp) / to_seconds(after->stamp - before.stamp);
  Instant between = before;
  between.stamp = time;
  between.odom_T_laser =
      before.odom_T_laser *
      Pose2::exp(share * (before.odom_T_laser.inverse() * after->odom_T_laser).log());
  between.moving = after->moving;
  return between;
}

// The vehicle moves while the scan is taken; the encoders tell how, well enough for so short a
// time.
ReflectorPoints SegmentRecorder::seen_at_first_beam(const ReflectorObservation& observation,
                                                    const Instant& first) const {
  ReflectorPoints points;
  const Pose2 first_T_odom = first.odom_T_laser.inverse();
  for (const SightedReflector& reflector : observation.reflectors) {
    const auto then = at(observation.first_beam + reflector.after_first_beam);
    const Pose2 first_T_then = then ? first_T_odom * then->odom_T_laser : Pose2();
    points.push_back(first_T_then * reflector.point);
  }
  return points;
}

void SegmentRecorder::use(const ReflectorObservation& observation) {
  const auto first = at(observation.first_beam);
  const auto last = at(observation.first_beam + from_seconds(params_.scan_duration));
  if (!first || !last) return;
  const Sight sight{seen_at_first_beam(observation, *first), first->odom_T_laser};
  const bool moved = first->ticks != last->ticks || first->moving || last->moving;
  if (!moved && at_rest()) {
    const Time settled = halted_since_ + from_seconds(params_.settling);
    if (observation.first_beam >= settled) halt_.push_back(sight);
  } else if (way_ && !way_->halted) {
    way_->sights.push_back(sight);
  }
}

void SegmentRecorder::begin_way(const Instant& from) {
  std::vector<Sight> start = std::move(halt_);
  halt_.clear();
  if (way_) {
    const auto half = start.begin() + static_cast<std::ptrdiff_t>(start.size() / 2);
    complete_way({start.begin(), half});
    start.erase(start.begin(), half);
  }
  way_.emplace();
  way_->begin = from.stamp;
  way_->least_steering = way_->greatest_steering = from.steering;
  way_->start = std::move(start);
}

void SegmentRecorder::extend_way(const Instant& from, const Instant& to) {
  const std::int64_t ticks = to.ticks - from.ticks;
  const double steering = 0.5 * (from.steering + to.steering);
  way_->end = to.stamp;
  way_->ticks += ticks;
  way_->steering_sum += static_cast<double>(ticks) * steering;
  way_->least_steering = std::min(way_->least_steering, to.steering);
  way_->greatest_steering = std::max(way_->greatest_steering, to.steering);
}

void SegmentRecorder::complete_way(const std::vector<Sight>& end) {
  done_.push_back(evaluate(*way_, end));
  way_.reset();
}

void SegmentRecorder::finish() {
  if (way_) complete_way(halt_);
  halt_.clear();
  waiting_.clear();
}

std::vector<RecordedSegment> SegmentRecorder::take() {
  std::vector<RecordedSegment> taken;
  taken.swap(done_);
  return taken;
}

RecordedSegment SegmentRecorder::evaluate(const Way& way, const std::vector<Sight>& end) const {
  RecordedSegment result;
  result.begin = way.begin;
  result.end = way.end;
  const auto refuse = [&](const std::string& complaint) {
    result.complaint = complaint;
    return result;
  };
  const double length = std::abs(static_cast<double>(way.ticks)) * params_.tricycle.driving_scale;
  if (length < params_.min_way) {
    return refuse("a way of " + std::to_string(length) + " m is too short");
  }
  if (way.greatest_steering - way.least_steering > params_.max_steering_change) {
    return refuse("the steering changed on the way by " +
                  std::to_string(way.greatest_steering - way.least_steering) +
                  " rad: it is no arc");
  }
  for (const auto* sights : {&way.start, &end}) {
    if (sights->size() >= params_.min_scans_at_rest) continue;
    return refuse(std::to_string(sights->size()) + " scans at rest " +
                  (sights == &end ? "after" : "before") + " it");
  }
  ReflectorMotionEstimator estimator(params_.reflectors);
  for (const Sight& sight : way.start) estimator.add_at_start(sight.points);
  Pose2 last = way.start.back().odom_T_laser;
  for (const Sight& sight : way.sights) {
    estimator.add_on_the_way(sight.points, last.inverse() * sight.odom_T_laser);
    last = sight.odom_T_laser;
  }
  for (const Sight& sight : end) {
    estimator.add_at_end(sight.points, last.inverse() * sight.odom_T_laser);
    last = sight.odom_T_laser;
  }
  result.lost_scans = estimator.lost_scans();
  const auto motion = estimator.result();
  if (!motion) return refuse(estimator.complaint());
  result.motion = *motion;
  const auto ticks = static_cast<double>(way.ticks);
  result.segment = {ticks, way.steering_sum / ticks, motion->start_T_end, motion->turn};
  return result;
}

}  // namespace falko_slam
