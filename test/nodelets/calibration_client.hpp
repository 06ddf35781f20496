// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <falko_slam/CalibrateAction.h>
#include <falko_slam/ComputeCalibration.h>
#include <falko_slam/DriveCommand.h>
#include <falko_slam/TricycleEncoders.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <string>
#include <vector>

#include "spin_until.hpp"

namespace falko_slam {
namespace test {

/// Asks a Calibration node of a namespace for calibrations and hears what it does.
class CalibrationClient {
 public:
  using State = actionlib::SimpleClientGoalState;

  explicit CalibrationClient(const std::string& name)
      : node_("/" + name), action_(node_, "calibrate", false) {
    commands_ = node_.subscribe<DriveCommand>(
        "drive_command", 1000, [this](const auto& message) { commands.push_back(*message); });
    encoders_ = node_.subscribe<TricycleEncoders>(
        "/encoders", 1000, [this](const auto& message) { ticks = message->drive_ticks; });
  }

  bool ready() {
    return spin_until([this] { return action_.isServerConnected() && ticks != 0; }, 20.0);
  }
  /// From where the vehicle started.
  void start(const CalibrateGoal& goal = {}) {
    std_srvs::Trigger reset;
    EXPECT_TRUE(ros::service::call("/nav350_simulator/reset", reset));
    go_on(goal);
  }
  /// From where it is.
  void go_on(const CalibrateGoal& goal = {}) {
    feedback.clear();
    commands.clear();
    action_.sendGoal(goal, {}, {}, [this](const auto& message) { feedback.push_back(*message); });
  }
  void cancel() { action_.cancelGoal(); }
  bool ended(double seconds = 90.0) {
    return spin_until([this] { return action_.getState().isDone(); }, seconds);
  }
  State state() { return action_.getState(); }
  CalibrateResult result() { return *action_.getResult(); }
  /// It is, or has been since the goal was sent.
  bool in_stage(const std::string& stage, int arc) {
    const auto there = [&](const CalibrateFeedback& told) {
      return told.stage == stage && told.arc == arc;
    };
    return spin_until([&] { return std::any_of(feedback.begin(), feedback.end(), there); }, 40.0);
  }
  ComputeCalibration::Response compute(ComputeCalibration::Request request = {}) {
    ComputeCalibration call;
    call.request = request;
    EXPECT_TRUE(ros::service::call(node_.resolveName("calibration/compute_calibration"), call));
    return call.response;
  }

  std::vector<CalibrateFeedback> feedback;  // of the last goal
  std::vector<DriveCommand> commands;       // since it was sent
  std::uint32_t ticks = 0;                  // of the vehicle, the newest

 private:
  ros::NodeHandle node_;
  actionlib::SimpleActionClient<CalibrateAction> action_;
  ros::Subscriber commands_, encoders_;
};

}  // namespace test
}  // namespace falko_slam
