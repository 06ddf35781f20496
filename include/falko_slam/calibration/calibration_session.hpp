// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/calibration/calibration_driver.hpp"
#include "falko_slam/calibration/recorded_calibration.hpp"

namespace falko_slam {

struct CalibrationSessionParams {
  CalibrationPlan plan;
  CalibrationDriverParams driver;
  /// Its tricycle and encoders are those of the driver, whatever stands here.
  SegmentRecorderParams recorder;
  CalibratorParams calibrator;
  /// So many arcs may give no segment; one more ends the calibration, [0, 400].
  int max_bad_arcs = 4;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const CalibrationSessionParams& params);

/// An arc that has been driven.
struct SessionArc {
  RecordedSegment recorded;
  /// Measured minus expected motion of the laser by what was believed before, (x [m], y [m],
  /// turn [rad]). Empty if there is a complaint.
  std::optional<Eigen::Vector3d> residual;
};

class SegmentWorker;

/// A calibration from its first command to its result: the driver leads, the recorder cuts the
/// drive into arcs in a thread of its own, and what they say is told arc by arc. Readings and
/// observations come in as with both; calls must come one after the other.
class CalibrationSession {
 public:
  /// Throws std::invalid_argument if a parameter is none, or the plan needs more than the area.
  explicit CalibrationSession(const CalibrationSessionParams& params);
  ~CalibrationSession();

  void add(const EncoderReading& reading);
  void add(const ReflectorObservation& observation);
  void add(const ScanObservation& observation);

  /// The command for the control period that begins now. Halts if the calibration is over.
  WheelCommand next(Time now);

  /// Ends it; the first reason is kept.
  void abort(const std::string& reason) { driver_.abort(reason); }

  const CalibrationDriver& driver() const { return driver_; }
  bool over() const { return driver_.done() || !driver_.reason().empty(); }
  /// The wheel has not moved for so long, or nobody can say whether it has.
  bool stands(Time now, Duration since) const;
  /// Waits until all that came in has been looked at.
  void catch_up();
  /// What has been driven so far, the arc at the end when its halt is over: as of the last command.
  const std::vector<SessionArc>& arcs() const { return arcs_; }

  /// The calibration from all arcs so far. Throws std::invalid_argument as calibrate() does.
  RecordedCalibration evaluate();

 private:
  void take_segments();

  CalibrationSessionParams params_;
  CalibrationDriver driver_;
  std::unique_ptr<SegmentWorker> worker_;
  std::vector<SessionArc> arcs_;
  std::optional<Time> moved_;  // the last reading with ticks of the wheel
  int bad_arcs_ = 0;
};

/// The recorded segments of a session's arcs.
std::vector<RecordedSegment> segments_of(const std::vector<SessionArc>& arcs);

}  // namespace falko_slam
