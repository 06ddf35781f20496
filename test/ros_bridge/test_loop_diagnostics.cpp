// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/loop_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include "ros_bridge/good_scan.hpp"

namespace falko_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

LoopDetection some_loop(LoopVerdict best) {
  LoopDetection detection;
  detection.candidates.resize(3);
  detection.candidates[0].target = {4};
  detection.candidates[0].verdict = best;
  detection.candidates[1].verdict = LoopVerdict::kLowScore;
  detection.candidates[2].verdict = LoopVerdict::kLowScore;
  return detection;
}

class LoopDiagnosticsTest : public ::testing::Test {
 protected:
  void SetUp() override { diagnostics_.report(status_, 100.0); }

  void expect(double now, int level, const std::string& text) {
    DiagnosticStatusWrapper status;
    diagnostics_.report(status, now);
    EXPECT_EQ(static_cast<int>(status.level), level);
    EXPECT_EQ(status.message, text);
  }
  std::string value(const std::string& key) {
    DiagnosticStatusWrapper status;
    diagnostics_.report(status, 101.0);
    for (const auto& entry : status.values) {
      if (entry.key == key) return entry.value;
    }
    return "no such key";
  }

  LoopDiagnostics diagnostics_{TopicWatch({"/scan", "sensor_msgs/LaserScan"}, 100.0, 1.5,
                                          [] { return std::optional<TopicDirectory>(); })};
  DiagnosticStatusWrapper status_;
};

TEST_F(LoopDiagnosticsTest, CountKeyframesAndLoops) {
  diagnostics_.received(test::good_scan(), 100.5);
  diagnostics_.added({20}, some_loop(LoopVerdict::kAccepted), 0.004);
  diagnostics_.added({21}, some_loop(LoopVerdict::kAmbiguous), 0.002);
  expect(101.0, DiagnosticStatus::OK, "2 keyframes, 1 loops");
  EXPECT_EQ(value("last loop accepted"), "20 with 4");
  EXPECT_EQ(value("candidates refused: score too low"), "4");
  EXPECT_EQ(value("candidates refused: accepted"), "no such key");
}

TEST_F(LoopDiagnosticsTest, TellTheTimeSpentSinceTheLastReport) {
  diagnostics_.added({20}, {}, 0.004);
  diagnostics_.added({21}, {}, 0.002);
  EXPECT_EQ(value("time per keyframe, mean [ms]"), "3.000");
  EXPECT_EQ(value("time per keyframe, mean [ms]"), "0.000");
}

TEST_F(LoopDiagnosticsTest, WarnOfScansThatTfCannotPlace) {
  diagnostics_.received(test::good_scan(), 100.5);
  diagnostics_.dropped("no transform from laser to odom");
  diagnostics_.dropped("no transform from laser to odom");
  expect(101.0, DiagnosticStatus::WARN, "2 scans dropped: no transform from laser to odom");
  diagnostics_.received(test::good_scan(), 101.5);
  expect(102.0, DiagnosticStatus::OK, "0 keyframes, 0 loops");
  EXPECT_EQ(value("scans dropped for want of a transform"), "2");
}

TEST_F(LoopDiagnosticsTest, WarnWhenScansStop) {
  expect(103.5, DiagnosticStatus::WARN, "no message on /scan for 3.5 s");
}

TEST_F(LoopDiagnosticsTest, TellOfScansWithoutUse) {
  ScanReport blind;
  blind.beam_count = 5;
  diagnostics_.received(blind, 100.5);
  expect(101.0, DiagnosticStatus::WARN, "no valid beam: " + describe(blind));
  ScanReport unusable;
  unusable.fault = ScanFault::kNoBeams;
  diagnostics_.received(unusable, 101.5);
  expect(102.0, DiagnosticStatus::ERROR, "unusable scan: " + describe(unusable));
  EXPECT_EQ(value("scans unusable"), "1");
}

TEST_F(LoopDiagnosticsTest, BeginAnewAfterALoad) {
  diagnostics_.received(test::good_scan(), 100.5);
  diagnostics_.added({20}, some_loop(LoopVerdict::kAccepted), 0.004);
  diagnostics_.loaded(300);
  expect(101.0, DiagnosticStatus::OK, "300 keyframes, 0 loops");
  EXPECT_EQ(value("keyframes loaded"), "300");
  EXPECT_EQ(value("last loop accepted"), "none yet");
}

}  // namespace
}  // namespace falko_slam
