// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/slam_diagnostics.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include "ros_bridge/good_scan.hpp"

namespace falko_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

TopicWatch scan_watch() {
  return TopicWatch({"/scan", "sensor_msgs/LaserScan"}, 100.0, 1.5,
                    [] { return std::optional<TopicDirectory>(); });
}

SlamStep anchored_step() {
  SlamStep step;
  step.keyframe = KeyframeId{0};
  step.is_keyframe = step.anchored = true;
  return step;
}

class SlamDiagnosticsTest : public ::testing::Test {
 protected:
  void SetUp() override { diagnostics_.report(status_, {100.0, 10.0}); }

  void expect(const SlamDiagnostics::Clock& now, int level, const std::string& text) {
    DiagnosticStatusWrapper status;
    diagnostics_.report(status, now);
    EXPECT_EQ(static_cast<int>(status.level), level);
    EXPECT_EQ(status.message, text);
  }
  std::string value(const std::string& key) {
    DiagnosticStatusWrapper status;
    diagnostics_.report(status, {101.0, 11.0});
    for (const auto& entry : status.values) {
      if (entry.key == key) return entry.value;
    }
    return "no such key";
  }
  void run() {
    diagnostics_.received(test::good_scan(), {100.5, 10.5});
    diagnostics_.processed(anchored_step(), 0.002);
  }

  SlamDiagnostics diagnostics_{scan_watch(), true, 3.0};
  DiagnosticStatusWrapper status_;
};

TEST_F(SlamDiagnosticsTest, CountKeyframesAndClosures) {
  run();
  std::vector<SlamClosure> closures(3);
  closures[0].accepted = true;
  closures[1].verdict = "against_odometry";
  diagnostics_.tally(7, closures);
  expect({101.0, 11.0}, DiagnosticStatus::OK, "7 keyframes, 1 closures");
  EXPECT_EQ(value("closures not accepted: against_odometry"), "1");
  EXPECT_EQ(value("closures not accepted: pending"), "1");
  EXPECT_EQ(value("anchored in the map"), "yes");
}

TEST_F(SlamDiagnosticsTest, TellTimesAndRate) {
  run();
  EXPECT_EQ(value("time per scan, mean [ms]"), "2.000");
  EXPECT_EQ(value("time per scan, mean [ms]"), "0.000");
  run();
  EXPECT_EQ(value("rate of scans [1/s]"), "0.00");  // in no time
}

TEST_F(SlamDiagnosticsTest, WarnOfWhatTfLacks) {
  run();
  diagnostics_.dropped("no transform from laser to odom");
  expect({101.0, 11.0}, DiagnosticStatus::WARN, "1 scans dropped: no transform from laser to odom");
  expect({101.0, 11.0}, DiagnosticStatus::OK, "1 keyframes, 0 closures");
  EXPECT_EQ(value("scans dropped for want of a transform"), "1");
}

TEST_F(SlamDiagnosticsTest, WarnOfTooMuchWork) {
  run();
  diagnostics_.overflowed();
  expect({101.0, 11.0}, DiagnosticStatus::WARN,
         "1 scans dropped: they come faster than they are done");
  EXPECT_EQ(value("scans dropped for want of time"), "1");
}

TEST_F(SlamDiagnosticsTest, WarnOfSilenceByEitherClock) {
  run();
  expect({104.5, 10.5}, DiagnosticStatus::WARN, "no message on /scan for 4.0 s");
  run();
  expect({100.5, 20.5}, DiagnosticStatus::WARN, "no message on /scan for 10.0 s");
  run();
  expect({100.6, 2.0}, DiagnosticStatus::OK, "3 keyframes, 0 closures");  // time has jumped back
}

TEST_F(SlamDiagnosticsTest, WarnOfScansThatFitNowhere) {
  run();
  SlamStep lost = anchored_step();
  lost.lost = true;
  lost.is_keyframe = false;
  diagnostics_.processed(lost, 0.001);
  expect({101.0, 11.0}, DiagnosticStatus::WARN,
         "1 scans fitted nowhere, odometry alone was believed");
}

TEST_F(SlamDiagnosticsTest, WarnWhileTheDriveHasNoPlaceAndWhilePaused) {
  run();
  SlamStep step = anchored_step();
  step.anchored = false;
  diagnostics_.processed(step, 0.001);
  expect({101.0, 11.0}, DiagnosticStatus::WARN, "the drive's place in the map is not known yet");
  diagnostics_.paused(true);
  expect({101.0, 11.0}, DiagnosticStatus::WARN, "paused");
}

TEST_F(SlamDiagnosticsTest, TellOfFailuresFirst) {
  run();
  diagnostics_.dropped("a transform");
  diagnostics_.failed("what went wrong");
  expect({101.0, 11.0}, DiagnosticStatus::ERROR, "what went wrong");
  ScanReport unusable;
  unusable.fault = ScanFault::kNoBeams;
  diagnostics_.received(unusable, {101.0, 11.0});
  expect({101.0, 11.0}, DiagnosticStatus::ERROR, "unusable scan: " + describe(unusable));
}

TEST_F(SlamDiagnosticsTest, ShowWarningsFromOutside) {
  run();
  diagnostics_.warn("somebody else sends it");
  expect({101.0, 11.0}, DiagnosticStatus::WARN, "somebody else sends it");
  diagnostics_.warn("");
  expect({101.0, 11.0}, DiagnosticStatus::OK, "1 keyframes, 0 closures");
}

TEST(SlamDiagnostics, SayThatThereIsNoOdometry) {
  SlamDiagnostics diagnostics(scan_watch(), false, 3.0);
  diagnostics.received(test::good_scan(), {100.5, 10.5});
  diagnostics.processed(anchored_step(), 0.002);
  DiagnosticStatusWrapper status;
  diagnostics.report(status, {100.6, 10.6});
  EXPECT_EQ(status.message, "1 keyframes, 0 closures, without odometry");
}

}  // namespace
}  // namespace falko_slam
