// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The action of the Calibration nodelet: from a goal to the vehicle at rest.
#include <falko_slam/DriveCommand.h>
#include <tf2/exceptions.h>

#include "calibration_nodelet.hpp"
#include "falko_slam/common/file_below.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

constexpr double kStanding = 0.3;  // without ticks for so long [s]

template <class Number>
void wish(Number wished, Number& value) {
  if (wished != Number(0)) value = wished;
}

// The parameters with what a goal asks for. Throws std::invalid_argument.
CalibrationSessionParams with_goal(CalibrationSessionParams params, const CalibrateGoal& goal) {
  wish(goal.arcs_per_phase, params.plan.arcs_per_phase);
  wish(goal.min_steering, params.plan.min_steering);
  wish(goal.max_steering, params.plan.max_steering);
  wish(goal.turn, params.plan.turn);
  wish(goal.wheel_speed, params.plan.wheel_speed);
  wish(goal.max_distance, params.plan.max_distance);
  CalibratorParams& calibrator = params.calibrator;
  calibrator.free_wheelbase = calibrator.free_wheelbase || goal.free_wheelbase;
  calibrator.free_steer_gain = calibrator.free_steer_gain || goal.free_steer_gain;
  if (!goal.model.empty()) calibrator.model = tricycle_model_of(goal.model);
  return params;
}

}  // namespace

void CalibrationNodelet::on_goal() {
  if (!session_) return begin(*server_->acceptNewGoal());
  session_->abort("a new goal has come");  // which waits until the vehicle stands
  on_control();
}

void CalibrationNodelet::on_preempt() {
  if (!session_) return;
  session_->abort("preempted");
  on_control();
}

Pose2 CalibrationNodelet::odom_T_base() {
  try {
    return in_plane(
        buffer_.lookupTransform(params_.odom_frame, params_.base_frame, ros::Time(0)).transform);
  } catch (const tf2::TransformException& error) {
    NODELET_WARN_STREAM("markers begin at the origin of " << params_.odom_frame << ": "
                                                          << error.what());
    return {};
  }
}

void CalibrationNodelet::draw() {
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  header.frame_id = params_.odom_frame;
  markers_->set_arcs(session_->arcs());
  marker_publisher_.publish(markers_->markers(header));
}

void CalibrationNodelet::begin(const CalibrateGoal& goal) {
  try {
    running_ = with_goal(params_.session, goal);
    file_ = goal.file.empty() ? params_.file : goal.file;
    if (!file_.empty()) file_below(params_.folder, file_);  // to know it before anything moves
    session_ = std::make_unique<CalibrationSession>(running_);
  } catch (const std::exception& error) {
    NODELET_ERROR_STREAM("goal refused: " << error.what());
    CalibrateResult result;
    result.message = error.what();
    return server_->setAborted(result, result.message);
  }
  if (server_->isPreemptRequested()) session_->abort("preempted");
  markers_ = std::make_unique<CalibrationMarkers>(running_, odom_T_base());
  over_ = false;
  now_ = from_ros(ros::Time::now());
  NODELET_INFO_STREAM("calibration begins: " << session_->driver().progress().arcs << " arcs");
  on_control();
}

void CalibrationNodelet::send(const WheelCommand& command) {
  DriveCommand message;
  message.header.stamp = ros::Time::now();
  message.wheel_speed = command.wheel_speed;
  message.steering = command.steering;
  commands_.publish(message);
}

void CalibrationNodelet::on_control() {
  if (!session_) return;
  const Time now = from_ros(ros::Time::now());
  if (now < now_) session_->abort("time has jumped back");
  now_ = now;
  send(session_->next(now));
  if (session_->over()) {
    if (!over_) over_since_ = now;
    over_ = true;
    const bool waited = now - over_since_ >= from_seconds(running_.driver.motion_timeout);
    if (waited || now < over_since_ || session_->stands(now, from_seconds(kStanding))) finish();
    return;
  }
  const ros::Time ros_now = ros::Time::now();
  if (ros_now >= last_feedback_ && (ros_now - last_feedback_).toSec() < params_.feedback_period) {
    return;
  }
  last_feedback_ = ros_now;
  send_feedback();
}

void CalibrationNodelet::send_feedback() {
  const CalibrationProgress progress = session_->driver().progress();
  CalibrateFeedback feedback;
  feedback.stage = name_of(progress.stage);
  feedback.phase = name_of(progress.phase);
  feedback.arc = static_cast<std::int32_t>(progress.arc + 1);
  feedback.arcs = static_cast<std::int32_t>(progress.arcs);
  feedback.fraction = progress.fraction;
  const Pose2& pose = session_->driver().start_T_base();
  feedback.start_T_base = pose2d(pose.x(), pose.y(), pose.theta());
  for (const SessionArc& arc : session_->arcs()) feedback.driven.push_back(to_message(arc));
  server_->publishFeedback(feedback);
  draw();
}

// The vehicle stands, or does not tell any more.
void CalibrationNodelet::finish() {
  CalibrateResult result;
  result.message = session_->driver().reason();
  bool sound = false;
  try {
    if (result.message.empty()) sound = conclude(session_->evaluate(), result);
  } catch (const std::exception& error) {
    result.message = error.what();
  }
  driven_ = session_->arcs();
  if (result.outcome.arcs.empty()) result.outcome.arcs = driven_arcs();
  draw();
  session_.reset();
  last_result_ = (sound ? "" : "no calibration: ") + result.message;
  NODELET_INFO_STREAM(last_result_);
  end_goal(result, sound);
}

void CalibrationNodelet::end_goal(const CalibrateResult& result, bool sound) {
  if (sound) {
    server_->setSucceeded(result, result.message);
  } else if (server_->isPreemptRequested()) {
    server_->setPreempted(result, result.message);
  } else {
    server_->setAborted(result, result.message);
  }
  if (server_->isNewGoalAvailable()) begin(*server_->acceptNewGoal());
}

}  // namespace falko_slam
