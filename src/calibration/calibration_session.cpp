// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/calibration/calibration_session.hpp"

#include <algorithm>
#include <utility>

#include "falko_slam/common/validation.hpp"
#include "segment_model.hpp"
#include "segment_worker.hpp"

namespace falko_slam {
namespace {

SegmentRecorderParams recorder_params(const CalibrationSessionParams& params) {
  SegmentRecorderParams recorder = params.recorder;
  recorder.tricycle = params.driver.tricycle;
  recorder.encoders = params.driver.encoders;
  return recorder;
}

Eigen::Vector3d residual_of(const PathSegment& segment, const CalibrationSessionParams& params) {
  VehicleCalibration believed;
  believed.tricycle = params.driver.tricycle;
  believed.steer_gain = params.calibrator.steer_gain;
  believed.base_T_laser = params.recorder.base_T_laser;
  const MeasuredStretch stretch = stretch_of(segment);
  return stretch.motion - predict(believed, stretch.arcs).motion;
}

const CalibrationSessionParams& validated(const CalibrationSessionParams& params) {
  validate(params);
  return params;
}

}  // namespace

void validate(const CalibrationSessionParams& params) {
  validate(params.plan);
  validate(params.driver);
  validate(recorder_params(params));
  validate(params.calibrator);
  require_in_range("max_bad_arcs", params.max_bad_arcs, 0, 400);
}

CalibrationSession::CalibrationSession(const CalibrationSessionParams& params)
    : params_(validated(params)),
      driver_(params.plan, params.driver),
      worker_(std::make_unique<SegmentWorker>(recorder_params(params))) {}

CalibrationSession::~CalibrationSession() = default;

void CalibrationSession::add(const EncoderReading& reading) {
  const std::int32_t ticks = driver_.add(reading);
  if (ticks != 0 || !moved_) moved_ = reading.stamp;
  worker_->add(reading);
}

void CalibrationSession::add(const ReflectorObservation& observation) {
  driver_.add_scan(observation.first_beam, observation.reflectors.size());
  worker_->add(observation);
}

void CalibrationSession::add(const ScanObservation& observation) {
  const std::vector<BeamStatus>& status = observation.scan.status;
  const auto valid = std::count(status.begin(), status.end(), BeamStatus::kValid);
  driver_.add_scan(observation.scan.first_beam_time, static_cast<std::size_t>(valid));
  worker_->add(observation);
}

void CalibrationSession::take_segments() {
  for (RecordedSegment& recorded : worker_->take()) {
    SessionArc arc;
    if (recorded.complaint.empty()) {
      arc.residual = residual_of(recorded.segment, params_);
    } else if (++bad_arcs_ > params_.max_bad_arcs) {
      abort("too many arcs without a measurement; the last one: " + recorded.complaint);
    }
    arc.recorded = std::move(recorded);
    arcs_.push_back(std::move(arc));
  }
}

WheelCommand CalibrationSession::next(Time now) {
  take_segments();
  return driver_.next(now);
}

void CalibrationSession::catch_up() {
  worker_->catch_up();
  take_segments();
}

bool CalibrationSession::stands(Time now, Duration since) const {
  return !moved_ || now - *moved_ >= since;
}

RecordedCalibration CalibrationSession::evaluate() {
  worker_->finish();
  take_segments();
  return calibrate_recorded(segments_of(arcs_), params_.calibrator,
                            params_.recorder.reflectors.lasting_noise);
}

std::vector<RecordedSegment> segments_of(const std::vector<SessionArc>& arcs) {
  std::vector<RecordedSegment> segments;
  segments.reserve(arcs.size());
  for (const SessionArc& arc : arcs) segments.push_back(arc.recorded);
  return segments;
}

}  // namespace falko_slam
