// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/driven_scan.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/carmen_lines.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

const std::vector<float> kWall(21, 2.0F);
const Pose2 kStart(5.0, -3.0, 1.0);  // map_T_odom where they agree
const Pose2 kAhead(0.1, 0.0, 0.0);

Pose2 odometry(int i) { return {0.1 * i, 0.0, 0.02 * i}; }

// Scans 0 to 9, of which the corrected log has 2 and 7.
std::string raw_log() {
  std::string log;
  for (int i = 0; i < 10; ++i) {
    log += test::flaser_line(kWall, odometry(i) * kAhead, odometry(i), 100.0 + i);
  }
  return log;
}

std::string corrected_log(const Pose2& error_at_7) {
  std::string log;
  for (const int i : {2, 7}) {
    const Pose2 pose = kStart * odometry(i) * (i == 7 ? error_at_7 : Pose2());
    log += test::vertex_line(static_cast<std::size_t>(i), pose);
    log += test::robotlaser_line(kWall, pose, pose, 100.0 + i);
  }
  return log;
}

class DrivenScans : public ::testing::Test {
 protected:
  std::vector<DrivenScan> load(const std::string& raw, const std::string& corrected) {
    return load_driven_scans(folder_.write("raw.log", raw), folder_.write("c.log", corrected),
                             report_);
  }
  static void expect_near(const Pose2& a, const Pose2& b, double tolerance) {
    EXPECT_LT((a.inverse() * b).log().norm(), tolerance) << a << " " << b;
  }

  test::TemporaryFolder folder_;
  CarmenReport report_;
};

TEST_F(DrivenScans, AreThoseBetweenTheFirstAndTheLastCorrectedOne) {
  const auto scans = load(raw_log(), corrected_log({}));
  ASSERT_EQ(scans.size(), 6U);
  for (int i = 0; i < 6; ++i) {
    const DrivenScan& scan = scans[static_cast<std::size_t>(i)];
    expect_near(scan.odom_T_laser, odometry(i + 2) * kAhead, 1e-6);
    expect_near(scan.map_T_laser, kStart * odometry(i + 2) * kAhead, 1e-6);
  }
  EXPECT_EQ(report_.scans, 10U);
}

TEST_F(DrivenScans, SpreadTheErrorOfTheOdometry) {
  const auto scans = load(raw_log(), corrected_log({0.5, 0.0, 0.0}));
  expect_near(scans[0].map_T_laser, kStart * odometry(2) * kAhead, 1e-6);
  expect_near(scans[5].map_T_laser, kStart * odometry(7) * Pose2(0.5, 0.0, 0.0) * kAhead, 1e-6);
  // Two of five steps: 0.2 m of 0.5.
  const Pose2 error = (kStart * odometry(4) * kAhead).inverse() * scans[2].map_T_laser;
  EXPECT_NEAR(error.translation().norm(), 0.2, 0.01);
}

TEST_F(DrivenScans, NeedTwoScansInBothLogs) {
  try {
    load(raw_log(), "VERTEX2 0 0 0 0\n" + test::robotlaser_line(kWall, {}, {}, 103.0));
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), folder_.file("raw.log") + ": 1 of its scans are in " +
                                             folder_.file("c.log") + ", need two");
  }
}

}  // namespace
}  // namespace falko_slam
