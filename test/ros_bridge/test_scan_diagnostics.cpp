// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <map>

namespace falko_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

ScanReport scan_of_ten() {
  ScanReport report;
  report.beam_count = 10;
  report.status_count[static_cast<std::size_t>(BeamStatus::kValid)] = 8;
  report.status_count[static_cast<std::size_t>(BeamStatus::kZero)] = 2;
  return report;
}

ScanReport blind_scan() {
  ScanReport report;
  report.beam_count = 10;
  report.status_count[static_cast<std::size_t>(BeamStatus::kZero)] = 10;
  return report;
}

ScanReport unusable_scan(ScanFault fault) {
  ScanReport report;
  report.fault = fault;
  return report;
}

class Diagnostics : public ::testing::Test {
 protected:
  DiagnosticStatusWrapper report(double now) {
    DiagnosticStatusWrapper status;
    diagnostics_.report(status, now);
    return status;
  }
  std::string value(double now, const std::string& key) {
    for (const auto& entry : report(now).values) {
      if (entry.key == key) return entry.value;
    }
    return "no such key";
  }
  void expect(double now, int level, const std::string& text) {
    const DiagnosticStatusWrapper status = report(now);
    EXPECT_EQ(static_cast<int>(status.level), level);
    EXPECT_EQ(status.message, text);
  }

  ScanDiagnostics diagnostics_{TopicWatch({"/scan", "sensor_msgs/LaserScan"}, 100.0, 3.0,
                                          [] { return std::optional<TopicDirectory>(); }),
                               100.0};
};

TEST_F(Diagnostics, AreOkWhileTheFirstScanMayStillCome) {
  expect(100.0, DiagnosticStatus::OK, "0.0 scans/s, 0.0 keypoints each");
  expect(102.5, DiagnosticStatus::OK, "0.0 scans/s, 0.0 keypoints each");
  EXPECT_EQ(value(102.5, "last scan"), "none yet");
}

TEST_F(Diagnostics, WarnWithoutAnyScan) {
  report(100.0);
  expect(103.5, DiagnosticStatus::WARN, "no message on /scan for 3.5 s");
}

TEST_F(Diagnostics, WarnWhenScansStop) {
  report(100.0);
  diagnostics_.add(scan_of_ten(), 4, 101.0, 0.001);
  expect(103.9, DiagnosticStatus::OK, "0.3 scans/s, 4.0 keypoints each");
  expect(104.1, DiagnosticStatus::WARN, "no message on /scan for 3.1 s");
}

TEST_F(Diagnostics, TellTheRateSinceTheLastReport) {
  report(100.0);
  for (int i = 1; i <= 16; ++i) diagnostics_.add(scan_of_ten(), 5, 100.0 + 0.125 * i, 0.001);
  expect(102.0, DiagnosticStatus::OK, "8.0 scans/s, 5.0 keypoints each");
  for (int i = 1; i <= 4; ++i) diagnostics_.add(scan_of_ten(), 2, 102.0 + 0.25 * i, 0.001);
  expect(103.0, DiagnosticStatus::OK, "4.0 scans/s, 2.0 keypoints each");
  EXPECT_EQ(value(103.5, "scans"), "20");
}

TEST_F(Diagnostics, TellTheTimeSpent) {
  report(100.0);
  diagnostics_.add(scan_of_ten(), 1, 100.5, 0.002);
  diagnostics_.add(scan_of_ten(), 1, 101.0, 0.004);
  const auto status = report(101.0);
  std::map<std::string, std::string> values;
  for (const auto& entry : status.values) values[entry.key] = entry.value;
  EXPECT_EQ(values["time per scan, mean [ms]"], "3.000");
  EXPECT_EQ(values["time per scan, longest [ms]"], "4.000");
  EXPECT_EQ(values["rate [1/s]"], "2.00");
  EXPECT_EQ(values["keypoints per scan"], "1.00");
  EXPECT_EQ(values["topic"], "/scan");
  EXPECT_EQ(values["last scan"], "10 beams: 8 valid, 2 zero");
  EXPECT_EQ(value(102.0, "time per scan, longest [ms]"), "0.000");
}

TEST_F(Diagnostics, WarnOfAScanWithoutValidBeams) {
  report(100.0);
  diagnostics_.add(blind_scan(), 0, 100.5, 0.001);
  expect(101.0, DiagnosticStatus::WARN, "no valid beam: 10 beams: 0 valid, 10 zero");
  diagnostics_.add(scan_of_ten(), 3, 101.5, 0.001);
  expect(102.0, DiagnosticStatus::OK, "1.0 scans/s, 3.0 keypoints each");
}

TEST_F(Diagnostics, WarnOfAnglesThatDisagree) {
  ScanReport scan = scan_of_ten();
  scan.angle_max_excess = -20.0;
  diagnostics_.add(scan, 3, 100.5, 0.001);
  expect(101.0, DiagnosticStatus::WARN,
         "angles and number of beams disagree: 10 beams: 8 valid, 2 zero; "
         "angle_max is 20.0 beams before the last one");
}

TEST_F(Diagnostics, TakeAnUnusableScanForAnError) {
  diagnostics_.add(unusable_scan(ScanFault::kNoBeams), 0, 100.5, 0.001);
  expect(101.0, DiagnosticStatus::ERROR, "unusable scan: no beams");
  EXPECT_EQ(value(101.5, "dropped: no beams"), "1");
  EXPECT_EQ(value(101.5, "dropped: bad angles"), "0");
}

TEST_F(Diagnostics, CountBadAngles) {
  diagnostics_.add(unusable_scan(ScanFault::kBadAngles), 0, 100.5, 0.001);
  EXPECT_EQ(report(101.0).level, DiagnosticStatus::ERROR);
  EXPECT_EQ(value(101.5, "dropped: bad angles"), "1");
  EXPECT_EQ(value(101.5, "dropped: no beams"), "0");
}

TEST_F(Diagnostics, CountInvalidBeams) {
  diagnostics_.add(scan_of_ten(), 3, 100.0, 0.001);
  diagnostics_.add(blind_scan(), 0, 100.1, 0.001);
  diagnostics_.add(unusable_scan(ScanFault::kNoBeams), 0, 100.2, 0.001);
  EXPECT_EQ(value(101.0, "invalid beams in used scans"), "12");
}

// The one that repeats the first is dropped, but nothing is wrong with it.
TEST_F(Diagnostics, SurplusBeamsAreNotInvalid) {
  ScanReport scan = scan_of_ten();
  scan.beam_count = 11;
  scan.surplus_beams = 1;
  diagnostics_.add(scan, 3, 100.0, 0.001);
  EXPECT_EQ(value(101.0, "invalid beams in used scans"), "2");
}

TEST_F(Diagnostics, CarryAWarningUntilItIsTakenBack) {
  diagnostics_.add(scan_of_ten(), 3, 100.0, 0.001);
  diagnostics_.warn("no transform");
  expect(100.5, DiagnosticStatus::WARN, "no transform");
  expect(101.0, DiagnosticStatus::WARN, "no transform");
  diagnostics_.warn("");
  expect(101.5, DiagnosticStatus::OK, "0.0 scans/s, 0.0 keypoints each");
}

}  // namespace
}  // namespace falko_slam
