// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/scan_tally.hpp"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include "ros_bridge/good_scan.hpp"

namespace falko_slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;

class ScanTallyTest : public ::testing::Test {
 protected:
  void expect(double now, int level, const std::string& text) {
    diagnostic_updater::DiagnosticStatusWrapper status;
    status.summary(DiagnosticStatus::OK, "as before");
    tally_.summarize(status, now);
    EXPECT_EQ(static_cast<int>(status.level), level);
    EXPECT_EQ(status.message, text);
  }

  ScanTally tally_{TopicWatch({"/scan", "sensor_msgs/LaserScan"}, 100.0, 1.5,
                              [] { return std::optional<TopicDirectory>(); })};
};

TEST_F(ScanTallyTest, LeavesAStatusWhileAllIsWell) {
  expect(101.0, DiagnosticStatus::OK, "as before");
  tally_.received(test::good_scan(), 101.0);
  expect(102.0, DiagnosticStatus::OK, "as before");
}

TEST_F(ScanTallyTest, TellsOfDropsUntilTheNextReport) {
  tally_.received(test::good_scan(), 101.0);
  tally_.dropped("no transform");
  expect(101.5, DiagnosticStatus::WARN, "1 scans dropped: no transform");
  tally_.begin_window();
  expect(101.5, DiagnosticStatus::OK, "as before");
  EXPECT_EQ(tally_.dropped_scans(), 1U);
}

TEST_F(ScanTallyTest, TellsOfSilenceBeforeAllElse) {
  ScanReport unusable;
  unusable.fault = ScanFault::kNoBeams;
  tally_.received(unusable, 101.0);
  tally_.dropped("no transform");
  expect(101.5, DiagnosticStatus::ERROR, "unusable scan: no beams");
  expect(103.0, DiagnosticStatus::WARN, "no message on /scan for 2.0 s");
}

}  // namespace
}  // namespace falko_slam
