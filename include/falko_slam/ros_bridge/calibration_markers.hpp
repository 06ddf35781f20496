// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "falko_slam/calibration/calibration_session.hpp"

namespace falko_slam {

/// A calibration for rviz: the arcs to drive ("planned", pale) and driven ("driven", blue), the
/// reflectors of the last scan ("reflectors", violet), and where an arc has ended, what it is off
/// by ("residuals"): by what was believed before (orange, kBelievedScale times as long), and by the
/// new calibration (green, or red if it was left out; kResidualScale times as long).
class CalibrationMarkers {
 public:
  static constexpr double kBelievedScale = 3.0;
  static constexpr double kResidualScale = 100.0;

  /// The vehicle stands at `odom_T_start` when it begins.
  CalibrationMarkers(const CalibrationSessionParams& params, const Pose2& odom_T_start);

  void add_pose(Time stamp, const Pose2& start_T_base);
  void set_reflectors(const ReflectorObservation& observation);
  /// All so far.
  void set_arcs(const std::vector<SessionArc>& arcs);
  void set_result(const RecordedCalibration& calibration);

  visualization_msgs::MarkerArray markers(const std_msgs::Header& header) const;

 private:
  struct Passed {
    Time stamp{};
    Pose2 odom_T_base;
  };
  struct Arrow {
    Pose2 odom_T_laser;        // at the end
    Eigen::Vector2d residual;  // as seen from the laser at the start [m]
    double turn = 0.0;         // from the start to the end [rad]
    enum class Kind { kBelieved, kCalibrated, kLeftOut } kind = Kind::kBelieved;
  };

  std::optional<Arrow> arrow_of(const SessionArc& arc) const;
  Pose2 place_at(Time stamp) const;

  Pose2 odom_T_start_, base_T_laser_;
  std::vector<Pose2> planned_;
  std::vector<Passed> driven_;
  std::vector<Eigen::Vector2d> reflectors_;   // in odom
  std::vector<std::optional<Arrow>> arrows_;  // arc by arc; empty after a complaint
};

}  // namespace falko_slam
