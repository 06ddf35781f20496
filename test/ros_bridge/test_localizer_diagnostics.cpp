// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localizer_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

namespace falko_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;

LocalizerReport ok_report() {
  LocalizerReport report;
  report.status = LocalizationStatus::kOk;
  report.reason = LocalizationReason::kNone;
  report.map_T_base = PoseEstimate{Pose2(), pose_covariance(0.01, 0.001)};
  return report;
}

class LocalizerDiagnosis : public ::testing::Test {
 protected:
  DiagnosticStatus at(double now, const LocalizerReport& state = ok_report()) {
    diagnostic_updater::DiagnosticStatusWrapper status;
    diagnostics_.report(status, now, state);
    return status;
  }

  static TopicWatch watch(const std::string& topic) {
    return TopicWatch({topic, ""}, 100.0, 1.0, [] { return std::optional<TopicDirectory>(); });
  }
  LocalizerDiagnostics diagnostics_{{}, watch("/encoders"), watch("/scan"), 100.0};
};

TEST_F(LocalizerDiagnosis, IsOkWhileAllIs) {
  diagnostics_.moved(101.0);
  diagnostics_.scanned(101.0, 0.001);
  const DiagnosticStatus status = at(101.5);
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "localized: ok");
}

TEST_F(LocalizerDiagnosis, NamesTopicsThatAreSilent) {
  diagnostics_.moved(102.9);
  EXPECT_EQ(at(103.0).message, "no message on /scan for 3.0 s");
  EXPECT_EQ(at(103.0).level, DiagnosticStatus::WARN);
}

TEST_F(LocalizerDiagnosis, CarriesWarningsUntilTheyAreTakenBack) {
  diagnostics_.moved(101.0);
  diagnostics_.scanned(101.0, 0.001);
  diagnostics_.warn_of_mount("another mount");
  diagnostics_.warn_of_odometry("no odometry");
  diagnostics_.warn_of_pose_file("no space");
  EXPECT_EQ(at(101.5).message, "another mount; no odometry; no space");
  diagnostics_.warn_of_mount("");
  diagnostics_.warn_of_odometry("");
  diagnostics_.warn_of_pose_file("");
  EXPECT_EQ(at(101.5).message, "localized: ok");
}

TEST_F(LocalizerDiagnosis, TellsStatusAndDeviations) {
  diagnostics_.moved(101.0);
  diagnostics_.scanned(101.0, 0.001);
  LocalizerReport report = ok_report();
  report.map_T_base->covariance = pose_covariance(0.2, 0.001);
  EXPECT_EQ(at(101.0, report).message, "standard deviation of 0.200 m, more than 0.050");
  report.status = LocalizationStatus::kDegraded;
  EXPECT_EQ(at(101.0, report).level, DiagnosticStatus::WARN);
  report.status = LocalizationStatus::kLost;
  EXPECT_EQ(at(101.0, report).level, DiagnosticStatus::ERROR);
}

}  // namespace
}  // namespace falko_slam
