// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/evaluation/posed_scan.hpp"

#include <gtest/gtest.h>

#include "support/carmen_lines.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using test::flaser_line;
using test::robotlaser_line;
using test::vertex_line;

const std::vector<float> kRanges = {1.0F, 2.0F, 3.0F};
const Pose2 kMount(0.3, 0.0, 0.1);
const Pose2 kInOdom(5.0, 6.0, 0.7);
const Pose2 kInMap(1.0, -2.0, 2.5);

void expect_near(const Pose2& a, const Pose2& b) {
  const Pose2 difference = a.inverse() * b;
  EXPECT_LT(difference.translation().norm(), 1e-9);
  EXPECT_LT(std::abs(difference.theta()), 1e-9);
}

class LoadPosedScans : public ::testing::Test {
 protected:
  std::vector<PosedScan> load(const std::string& text) {
    return load_posed_scans(folder_.write("test.log", text), report_);
  }
  std::string error_of(const std::string& text) {
    try {
      load(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  CarmenReport report_;
};

TEST_F(LoadPosedScans, PutsTheMountOnTheVertex) {
  const auto scans =
      load(vertex_line(0, kInMap) + robotlaser_line(kRanges, kInOdom * kMount, kInOdom, 1.0));
  ASSERT_EQ(scans.size(), 1U);
  expect_near(scans[0].map_T_laser, kInMap * kMount);
  EXPECT_EQ(scans[0].scan.ranges, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(report_.vertices, 1U);
}

TEST_F(LoadPosedScans, TakesTheCorrectedLaserPoseOfFlaser) {
  const Pose2 elsewhere(-3.0, 4.0, 0.2);
  const auto scans = load(flaser_line(kRanges, kInMap, kInOdom, 1.0) +
                          flaser_line(kRanges, elsewhere, kInOdom, 2.0));
  ASSERT_EQ(scans.size(), 2U);
  expect_near(scans[0].map_T_laser, kInMap);
  expect_near(scans[1].map_T_laser, elsewhere);
}

TEST_F(LoadPosedScans, LeavesOutWhatCannotBeUsedAndItsVertex) {
  const Pose2 other(8.0, 8.0, 0.0);
  const auto scans = load(vertex_line(0, other) + robotlaser_line({}, kInOdom, kInOdom, 1.0) +
                          vertex_line(1, kInMap) + robotlaser_line(kRanges, kInOdom, kInOdom, 2.0));
  ASSERT_EQ(scans.size(), 1U);
  expect_near(scans[0].map_T_laser, kInMap);
}

TEST_F(LoadPosedScans, RefusesALogWithoutPoses) {
  const std::string error = error_of("FLASER 3 1 2 3\nFLASER 3 1 2 3\n");
  EXPECT_NE(error.find("test.log: no laser scan in 2 lines"), std::string::npos) << error;
  EXPECT_NE(error.find("2 malformed lines left out: 1 2"), std::string::npos) << error;
}

// Its laser pose is the odometry with the mount in front, always the same one.
TEST_F(LoadPosedScans, RefusesALogOfRawOdometry) {
  const Pose2 later(6.0, 6.5, 0.9);
  for (const auto& line : {flaser_line, robotlaser_line}) {
    const std::string error = error_of(line(kRanges, kInOdom * kMount, kInOdom, 1.0) +
                                       line(kRanges, later * kMount, later, 2.0));
    EXPECT_NE(error.find("test.log: no corrected poses"), std::string::npos) << error;
  }
}

TEST_F(LoadPosedScans, RefusesALogWithVerticesForSomeScansOnly) {
  const std::string error =
      error_of(vertex_line(0, kInMap) + robotlaser_line(kRanges, kInOdom, kInOdom, 1.0) +
               robotlaser_line(kRanges, kInOdom, kInOdom, 2.0));
  EXPECT_NE(error.find("test.log: 1 of 2 scans without a VERTEX2 line"), std::string::npos)
      << error;
}

// The vertex of a scan that is left out must not become that of the next one.
TEST_F(LoadPosedScans, AVertexBelongsToTheScanBehindItOnly) {
  const std::string error =
      error_of(vertex_line(0, kInMap) + robotlaser_line({}, kInOdom, kInOdom, 1.0) +
               robotlaser_line(kRanges, kInOdom, kInOdom, 2.0) + vertex_line(1, kInMap) +
               robotlaser_line(kRanges, kInOdom, kInOdom, 3.0));
  EXPECT_NE(error.find("1 of 2 scans without a VERTEX2 line"), std::string::npos) << error;
}

TEST_F(LoadPosedScans, RefusesALogWithoutScans) {
  EXPECT_NE(error_of("ODOM 1 2 0.3 0.4 0.5 0 12.25 host 0\n").find("test.log: no laser scan"),
            std::string::npos);
  EXPECT_NE(error_of("").find("test.log: no laser scan"), std::string::npos);
}

TEST_F(LoadPosedScans, NamesAFileThatIsNotThere) {
  try {
    load_posed_scans(folder_.file("missing.log"), report_);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("missing.log"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace falko_slam
