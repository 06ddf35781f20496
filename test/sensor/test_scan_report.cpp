// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/scan_report.hpp"

#include <gtest/gtest.h>

namespace falko_slam {
namespace {

void set_count(ScanReport& report, BeamStatus status, std::size_t count) {
  report.status_count[static_cast<std::size_t>(status)] = count;
}

TEST(DescribeScanReport, TellsTheFault) {
  ScanReport report;
  report.fault = ScanFault::kNoBeams;
  EXPECT_EQ(describe(report), "no beams");
  report.fault = ScanFault::kBadAngles;
  report.beam_count = 1;
  EXPECT_EQ(describe(report), "1 beam with unusable angle_min, angle_max or angle_increment");
}

TEST(DescribeScanReport, CountsWhatFell) {
  ScanReport report;
  report.beam_count = 20;
  set_count(report, BeamStatus::kValid, 10);
  set_count(report, BeamStatus::kNoReturn, 1);
  set_count(report, BeamStatus::kZero, 2);
  set_count(report, BeamStatus::kTooNear, 3);
  set_count(report, BeamStatus::kTooFar, 4);
  EXPECT_EQ(describe(report),
            "20 beams: 10 valid, 1 without return, 2 zero, 3 below range_min, 4 above range_max");
}

TEST(DescribeScanReport, TellsWhatWasMended) {
  ScanReport report;
  report.beam_count = 1441;
  set_count(report, BeamStatus::kValid, 1440);
  report.surplus_beams = 1;
  report.angle_max_excess = -2.0;
  report.angle_increment_derived = true;
  report.missing_intensities = 7;
  EXPECT_EQ(
      describe(report),
      "1441 beams: 1440 valid; 1 beyond a full turn dropped; angle_max is 2.0 beams before the "
      "last one; angle_increment taken from angle_max; 7 intensities missing");
}

}  // namespace
}  // namespace falko_slam
