// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/segment_recorder.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>
#include <variant>

#include "encoder_track.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "segment_way.hpp"

namespace falko_slam {
namespace {

struct TakenFrom {
  Time begin{};
  Duration duration{};
};

TakenFrom time_of(const ReflectorObservation& observation, Duration duration) {
  return {observation.first_beam, duration};
}

// From its earliest beam to its latest.
TakenFrom time_of(const ScanObservation& observation, Duration) {
  const LaserScan& scan = observation.scan;
  if (scan.size() == 0) return {scan.first_beam_time, Duration::zero()};
  const Time first = scan.first_beam_time, last = scan.beam_time(scan.size() - 1);
  return {std::min(first, last), std::max(first, last) - std::min(first, last)};
}

// The vehicle moves while the scan is taken; the encoders tell how, well enough for so short a
// time.
Sight seen_from(const ReflectorObservation& observation, const EncoderTrack& track,
                const EncoderInstant& first, const EncoderInstant&) {
  ReflectorPoints points;
  const Pose2 first_T_odom = first.odom_T_laser.inverse();
  for (const SightedReflector& reflector : observation.reflectors) {
    const auto then = track.at(observation.first_beam + reflector.after_first_beam);
    const Pose2 first_T_then = then ? first_T_odom * then->odom_T_laser : Pose2();
    points.push_back(first_T_then * reflector.point);
  }
  return {points, first.odom_T_laser};
}

// As if all beams had left with the first one that did.
Sight seen_from(const ScanObservation& observation, const EncoderTrack&,
                const EncoderInstant& first, const EncoderInstant& last) {
  const LaserMotion sweep{first.odom_T_laser.inverse() * last.odom_T_laser,
                          last.stamp - first.stamp};
  return {SweptScan{observation.scan, sweep}, first.odom_T_laser};
}

}  // namespace

const char* name_of(EgomotionSource source) {
  return source == EgomotionSource::kScans ? "scans" : "reflectors";
}

void validate(const SegmentRecorderParams& params) {
  validate(params.tricycle);
  validate(params.encoders);
  validate(params.reflectors);
  validate(params.scans);
  require_in_range("scan_duration", params.scan_duration, 0.0, 10.0);
  require_in_range("settling", params.settling, 0.0, 60.0);
  require_in_range<std::size_t>("min_scans_at_rest", params.min_scans_at_rest, 1, 10000);
  require_in_range("min_way", params.min_way, 0.0, 1000.0);
  require_in_range("max_steering_change", params.max_steering_change, 0.0, kPi);
  require_in_range<std::size_t>("max_scans_at_rest", params.max_scans_at_rest, 2, 100000);
  require_in_range<std::size_t>("max_scans_on_the_way", params.max_scans_on_the_way, 1, 1000000);
  require_in_range<std::size_t>("max_waiting_scans", params.max_waiting_scans, 1, 10000);
}

struct SegmentRecorder::Impl {
  using Observation = std::variant<ReflectorObservation, ScanObservation>;

  explicit Impl(const SegmentRecorderParams& recorder_params)
      : params((validate(recorder_params), recorder_params)),
        track(params.tricycle, params.encoders, params.base_T_laser) {}

  bool at_rest() const { return !way || way->halted; }
  void add(const EncoderReading& reading);
  void wait_with(Observation observation);
  void use_waiting_until(Time reading);
  void use(const Observation& observation);
  void keep_at_rest(Sight sight);
  void keep_on_the_way(Sight sight);
  void begin_way(const EncoderInstant& from);
  void complete_way(const std::vector<Sight>& end);
  void finish();

  const SegmentRecorderParams params;
  EncoderTrack track;
  std::deque<Observation> waiting;
  std::optional<Way> way;   // the last one, or the one that is being driven
  std::vector<Sight> halt;  // since the last halt
  Time halted_since{};
  std::size_t lost_waiting = 0;  // since the last segment
  std::vector<RecordedSegment> done;
};

void SegmentRecorder::Impl::add(const EncoderReading& reading) {
  if (!track.add(reading)) return;
  const EncoderInstant& now = track.last();
  if (track.first()) {
    halted_since = now.stamp;
  } else if (now.moving) {
    const EncoderInstant& before = track.before_last();
    use_waiting_until(before.stamp);
    if (at_rest()) begin_way(before);
    way->extend(before, now);
  } else if (way && !way->halted && now.stamp - way->end >= from_seconds(params.settling)) {
    way->halted = true;
    halted_since = way->end;
  }
  use_waiting_until(now.stamp);
}

void SegmentRecorder::Impl::wait_with(Observation observation) {
  waiting.push_back(std::move(observation));
  if (!track.empty()) use_waiting_until(track.last().stamp);
  if (waiting.size() <= params.max_waiting_scans) return;
  waiting.pop_front();
  if (!track.empty()) ++lost_waiting;
}

// Those whose last beam is not later.
void SegmentRecorder::Impl::use_waiting_until(Time reading) {
  const Duration duration = from_seconds(params.scan_duration);
  while (!waiting.empty()) {
    const bool late = std::visit(
        [&](const auto& observation) {
          const TakenFrom taken = time_of(observation, duration);
          return taken.begin + taken.duration > reading;
        },
        waiting.front());
    if (late) return;
    use(waiting.front());
    waiting.pop_front();
  }
}

void SegmentRecorder::Impl::use(const Observation& observation) {
  std::visit(
      [&](const auto& seen) {
        const TakenFrom taken = time_of(seen, from_seconds(params.scan_duration));
        const auto first = track.at(taken.begin);
        const auto last = track.at(taken.begin + taken.duration);
        if (!first || !last) return;
        const bool moved = first->ticks != last->ticks || first->moving || last->moving;
        if (!moved && at_rest()) {
          const Time settled = halted_since + from_seconds(params.settling);
          if (taken.begin >= settled) keep_at_rest(seen_from(seen, track, *first, *last));
        } else if (way && !way->halted) {
          keep_on_the_way(seen_from(seen, track, *first, *last));
        }
      },
      observation);
}

void SegmentRecorder::Impl::keep_at_rest(Sight sight) {
  halt.push_back(std::move(sight));
  if (halt.size() <= params.max_scans_at_rest) return;
  halt.erase(halt.begin() + static_cast<std::ptrdiff_t>(halt.size() / 2));
}

void SegmentRecorder::Impl::keep_on_the_way(Sight sight) {
  if (way->too_long) return;
  way->sights.push_back(std::move(sight));
  if (way->sights.size() <= params.max_scans_on_the_way) return;
  way->too_long = true;
  way->sights = {};
}

void SegmentRecorder::Impl::begin_way(const EncoderInstant& from) {
  std::vector<Sight> start = std::move(halt);
  halt.clear();
  if (way) {
    const auto half = start.begin() + static_cast<std::ptrdiff_t>(start.size() / 2);
    complete_way({start.begin(), half});
    start.erase(start.begin(), half);
  }
  way.emplace();
  way->begin = from.stamp;
  way->least_steering = way->greatest_steering = from.steering;
  way->start = std::move(start);
}

void SegmentRecorder::Impl::complete_way(const std::vector<Sight>& end) {
  RecordedSegment segment = evaluate(*way, end, params);
  if (lost_waiting > 0) {
    segment.complaint = "the encoders were silent while " + std::to_string(lost_waiting) +
                        " scans came that could not wait";
  }
  lost_waiting = 0;
  done.push_back(std::move(segment));
  way.reset();
}

void SegmentRecorder::Impl::finish() {
  if (way) complete_way(halt);
  halt.clear();
  waiting.clear();
  lost_waiting = 0;
}

SegmentRecorder::SegmentRecorder(const SegmentRecorderParams& params)
    : impl_(std::make_unique<Impl>(params)) {}
SegmentRecorder::~SegmentRecorder() = default;
SegmentRecorder::SegmentRecorder(SegmentRecorder&&) noexcept = default;
SegmentRecorder& SegmentRecorder::operator=(SegmentRecorder&&) noexcept = default;

void SegmentRecorder::add(const EncoderReading& reading) { impl_->add(reading); }

void SegmentRecorder::add(const ReflectorObservation& observation) {
  if (impl_->params.egomotion == EgomotionSource::kReflectors) impl_->wait_with(observation);
}

void SegmentRecorder::add(const ScanObservation& observation) {
  if (impl_->params.egomotion == EgomotionSource::kScans) impl_->wait_with(observation);
}

void SegmentRecorder::finish() { impl_->finish(); }

std::vector<RecordedSegment> SegmentRecorder::take() {
  std::vector<RecordedSegment> taken;
  taken.swap(impl_->done);
  return taken;
}

bool SegmentRecorder::at_rest() const { return impl_->at_rest(); }
std::size_t SegmentRecorder::scans_at_rest() const { return impl_->halt.size(); }

}  // namespace falko_slam
