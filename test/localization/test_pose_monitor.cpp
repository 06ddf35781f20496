// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_monitor.hpp"

#include <gtest/gtest.h>

#include "falko_slam/localization/localizer_params.hpp"

namespace falko_slam {
namespace {

using Reason = LocalizationReason;

class PoseMonitorTest : public ::testing::Test {
 protected:
  PoseMonitorTest() { monitor_.begin(now_, 0.0); }

  // Scans of one kind, an eighth of a second from each other, with motions.
  void scans(int count, const ScanEvidence& scan) {
    for (int i = 0; i < count; ++i) {
      now_ += std::chrono::milliseconds(125);
      monitor_.motion_seen(now_);
      monitor_.add(now_, scan);
    }
  }
  static ScanEvidence good_scan() {
    ScanEvidence scan;
    scan.agreement.used = scan.agreement.expected = 4;
    scan.agreement.nis = scan.agreement.degrees_of_freedom = 8;
    scan.log_odds = 3.0;
    return scan;
  }
  PoseVerdict verdict(double later = 0.0) const {
    return monitor_.judge(now_ + from_seconds(later), pose_);
  }
  void expect(LocalizationStatus status, Reason reason, double later = 0.0) const {
    EXPECT_EQ(verdict(later).first, status) << name_of(verdict(later).first);
    EXPECT_EQ(verdict(later).second, reason) << name_of(verdict(later).second);
  }

  Time now_{std::chrono::seconds(100)};
  PoseEstimate pose_{{}, pose_covariance(0.01, 0.005)};
  PoseMonitorParams params_;
  PoseMonitor monitor_{params_};
};

TEST_F(PoseMonitorTest, IsOkOnlyAfterScansHaveAgreed) {
  expect(LocalizationStatus::kDegraded, Reason::kUnconfirmed);
  scans(2, good_scan());
  expect(LocalizationStatus::kDegraded, Reason::kUnconfirmed);
  scans(1, good_scan());
  expect(LocalizationStatus::kOk, Reason::kNone);
}

TEST_F(PoseMonitorTest, IsLostWhenScansContradict) {
  scans(10, good_scan());
  ScanEvidence bad;
  bad.agreement.strangers = 4;
  bad.log_odds = -4.0;
  scans(4, bad);
  EXPECT_EQ(verdict().first, LocalizationStatus::kDegraded);
  scans(10, bad);
  expect(LocalizationStatus::kLost, Reason::kContradicted);
  EXPECT_EQ(monitor_.evidence(), -params_.bound);
}

TEST_F(PoseMonitorTest, TakesAScanThatIsOlderThanTheWindow) {
  monitor_.add(now_ - from_seconds(5.0), good_scan());
  expect(LocalizationStatus::kDegraded, Reason::kUnconfirmed);
  scans(3, good_scan());
  expect(LocalizationStatus::kOk, Reason::kNone);
}

TEST_F(PoseMonitorTest, SaysWhichInputIsSilent) {
  scans(10, good_scan());
  expect(LocalizationStatus::kDegraded, Reason::kNoMotions, 0.4);
  monitor_.motion_seen(now_ + from_seconds(0.7));
  expect(LocalizationStatus::kDegraded, Reason::kNoScans, 0.7);
  expect(LocalizationStatus::kLost, Reason::kNoSensors, 11.0);
}

TEST_F(PoseMonitorTest, SaysWhatTheWindowDoesNotLike) {
  ScanEvidence scan = good_scan();
  scan.agreement.nis = 50.0;
  scans(20, scan);
  expect(LocalizationStatus::kDegraded, Reason::kMisfit);
  scan = good_scan();
  scan.agreement.missed = 3;
  scans(20, scan);
  expect(LocalizationStatus::kDegraded, Reason::kMapDisagrees);
  scan = good_scan();
  scan.agreement.used = scan.agreement.expected = 1;
  scan.agreement.nis = scan.agreement.degrees_of_freedom = 2;
  scans(20, scan);
  expect(LocalizationStatus::kDegraded, Reason::kFewLandmarks);
}

TEST_F(PoseMonitorTest, JudgesTheCovariance) {
  scans(10, good_scan());
  pose_.covariance = pose_covariance(0.1, 0.005);
  expect(LocalizationStatus::kDegraded, Reason::kUncertain);
  pose_.covariance = pose_covariance(0.01, 0.5);
  expect(LocalizationStatus::kLost, Reason::kTooUncertain);
}

TEST_F(PoseMonitorTest, RemembersWhatHasHappened) {
  scans(10, good_scan());
  monitor_.odometry_disagreed(now_);
  expect(LocalizationStatus::kDegraded, Reason::kOdometryDisagrees);
  monitor_.clock_set_back(now_);
  expect(LocalizationStatus::kDegraded, Reason::kClockSetBack);
  monitor_.begin(now_, 100.0);
  EXPECT_EQ(monitor_.evidence(), params_.bound);
  monitor_.scene_changed(now_);
  expect(LocalizationStatus::kLost, Reason::kCarried, 1.5);
  scans(10, good_scan());
  expect(LocalizationStatus::kOk, Reason::kNone);
}

}  // namespace
}  // namespace falko_slam
