// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <falko_slam/CalibrateAction.h>
#include <falko_slam/ComputeCalibration.h>
#include <falko_slam/ReflectorArray.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>
#include <vector>

#include "encoder_input.hpp"
#include "falko_slam/calibration/calibration_file.hpp"
#include "falko_slam/ros_bridge/calibration_conversion.hpp"
#include "falko_slam/ros_bridge/calibration_markers.hpp"
#include "falko_slam/ros_bridge/calibration_node_params.hpp"

namespace falko_slam {

/// Calibrates a tricycle and its scanner: a wrapper of CalibrationSession.
///
/// Action `calibrate` drives the arcs: subscribes `encoders` or `joint_states`, and `reflectors` or
/// `scan`; publishes `drive_command` while it drives, and `calibration_markers`. Whatever goes
/// wrong halts the vehicle within the control period, and the action ends as soon as it stands.
/// Service
/// `~compute_calibration` calibrates from arcs that have been driven. Parameters:
/// config/calibration.yaml.
///
/// All callbacks come one after the other from a queue and thread of our own: the vehicle must not
/// wait for the other nodelets of a manager.
class CalibrationNodelet : public nodelet::Nodelet {
 public:
  ~CalibrationNodelet() override;

 private:
  using Server = actionlib::SimpleActionServer<CalibrateAction>;

  void onInit() override;
  void load_parameters();
  void start_listening();
  void start_serving();
  void abort_drive();

  void on_reading(const EncoderReading& reading);
  void on_reflectors(const ReflectorArray& message);
  void on_scan(const sensor_msgs::LaserScan& message);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  // calibration_action.cpp
  void on_goal();
  void on_preempt();
  void on_control();
  void begin(const CalibrateGoal& goal);
  void send(const WheelCommand& command);
  void send_feedback();
  void finish();
  void end_goal(const CalibrateResult& result, bool sound);
  void draw();
  Pose2 odom_T_base();

  // calibration_outcome.cpp
  struct KeepWish {
    std::string file;  // empty: nothing is written
    bool accept_weak;
  };
  bool on_compute(ComputeCalibration::Request& request, ComputeCalibration::Response& response);
  /// False if there are no numbers.
  bool conclude(const RecordedCalibration& calibration, CalibrateResult& result);
  /// Says what has been written, or why nothing was.
  std::string keep(const CalibrationResult& result, TricycleModel model, const KeepWish& wish,
                   CalibrationOutcome& outcome) const;
  std::vector<CalibrationArc> driven_arcs() const;

  CalibrationNodeParams params_;
  ros::CallbackQueue queue_;
  std::unique_ptr<Server> server_;
  std::unique_ptr<CalibrationSession> session_;  // null: nothing is driven
  CalibrationSessionParams running_;             // of the session, after the goal's wishes
  std::string file_;                             // for its result
  std::vector<SessionArc> driven_;               // in the last session
  std::unique_ptr<CalibrationMarkers> markers_;
  ScanObservation scan_;  // its memory is used again
  Time now_{}, over_since_{};
  ros::Time last_feedback_;
  bool over_ = false;
  std::size_t readings_ = 0, scan_count_ = 0;  // received, since the last report
  std::string last_result_ = "nothing calibrated yet";

  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> transforms_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::Publisher commands_, marker_publisher_;
  std::unique_ptr<EncoderInput> encoders_;
  std::unique_ptr<TopicWatch> encoder_watch_, scan_watch_;
  ros::Subscriber scans_;
  ros::ServiceServer compute_;
  ros::Timer control_timer_;
  ros::WallTimer diagnostics_timer_;
  std::unique_ptr<ros::AsyncSpinner> thread_;
};

}  // namespace falko_slam
