// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_way.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

void add_at_start(ReflectorMotionEstimator& estimator, const Sight& sight) {
  estimator.add_at_start(std::get<ReflectorPoints>(sight.seen));
}
void add_on_the_way(ReflectorMotionEstimator& estimator, const Sight& sight, const Pose2& step) {
  estimator.add_on_the_way(std::get<ReflectorPoints>(sight.seen), step);
}
void add_at_end(ReflectorMotionEstimator& estimator, const Sight& sight, const Pose2& step) {
  estimator.add_at_end(std::get<ReflectorPoints>(sight.seen), step);
}

void add_at_start(ScanMotionEstimator& estimator, const Sight& sight) {
  estimator.add_at_start(std::get<SweptScan>(sight.seen).scan);
}
void add_on_the_way(ScanMotionEstimator& estimator, const Sight& sight, const Pose2& step) {
  const auto& [scan, sweep] = std::get<SweptScan>(sight.seen);
  estimator.add_on_the_way(scan, step, sweep);
}
void add_at_end(ScanMotionEstimator& estimator, const Sight& sight, const Pose2& step) {
  estimator.add_at_end(std::get<SweptScan>(sight.seen).scan, step);
}

template <class Estimator>
auto motion_of(Estimator estimator, const Way& way, const std::vector<Sight>& end,
               RecordedSegment& result) {
  for (const Sight& sight : way.start) add_at_start(estimator, sight);
  Pose2 last = way.start.back().odom_T_laser;
  for (const Sight& sight : way.sights) {
    add_on_the_way(estimator, sight, last.inverse() * sight.odom_T_laser);
    last = sight.odom_T_laser;
  }
  for (const Sight& sight : end) {
    add_at_end(estimator, sight, last.inverse() * sight.odom_T_laser);
    last = sight.odom_T_laser;
  }
  auto motion = estimator.result();
  result.lost_scans = estimator.lost_scans();
  if (!motion) {
    result.complaint = estimator.complaint();
  } else {
    const auto ticks = static_cast<double>(way.ticks);
    result.segment = {ticks, way.steering_sum / ticks, motion->start_T_end, motion->turn};
  }
  return motion;
}

// Empty: nothing.
std::string objection(const Way& way, const std::vector<Sight>& end,
                      const SegmentRecorderParams& params) {
  const double length = std::abs(static_cast<double>(way.ticks)) * params.tricycle.driving_scale;
  if (length < params.min_way) {
    return "a way of " + std::to_string(length) + " m is too short";
  }
  const double change = way.greatest_steering - way.least_steering;
  if (change > params.max_steering_change) {
    return "the steering changed on the way by " + std::to_string(change) + " rad: it is no arc";
  }
  if (way.too_long) {
    return "more than " + std::to_string(params.max_scans_on_the_way) + " scans on the way";
  }
  for (const auto* sights : {&way.start, &end}) {
    if (sights->size() >= params.min_scans_at_rest) continue;
    return std::to_string(sights->size()) + " scans at rest " +
           (sights == &end ? "after" : "before") + " it";
  }
  return "";
}

}  // namespace

void Way::extend(const EncoderInstant& from, const EncoderInstant& to) {
  const std::int64_t driven = to.ticks - from.ticks;
  const double steering = 0.5 * (from.steering + to.steering);
  end = to.stamp;
  ticks += driven;
  steering_sum += static_cast<double>(driven) * steering;
  least_steering = std::min(least_steering, to.steering);
  greatest_steering = std::max(greatest_steering, to.steering);
}

RecordedSegment evaluate(const Way& way, const std::vector<Sight>& end,
                         const SegmentRecorderParams& params) {
  RecordedSegment result;
  result.begin = way.begin;
  result.end = way.end;
  result.egomotion = params.egomotion;
  result.complaint = objection(way, end, params);
  if (!result.complaint.empty()) return result;
  if (params.egomotion == EgomotionSource::kReflectors) {
    const auto motion = motion_of(ReflectorMotionEstimator(params.reflectors), way, end, result);
    if (motion) result.motion = *motion;
  } else {
    const auto motion = motion_of(ScanMotionEstimator(params.scans), way, end, result);
    if (motion) result.scan_motion = *motion;
  }
  return result;
}

}  // namespace falko_slam
