// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/carmen_log.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "falko_slam/geometry/angles.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

std::string flaser(int beams, const std::string& rest) {
  std::ostringstream line;
  line << "FLASER " << beams;
  for (int i = 0; i < beams; ++i) line << " " << 1.0 + 0.01 * i;
  line << " " << rest << "\n";
  return line.str();
}

const char kPoses[] = "1.1 2 0.5 1.0 2 0.5 976052857.337530 host 0.1";

std::vector<CarmenRecord> read_all(CarmenLogReader& reader) {
  std::vector<CarmenRecord> records;
  while (auto record = reader.next()) records.push_back(*record);
  return records;
}

class CarmenLog : public ::testing::Test {
 protected:
  std::vector<CarmenRecord> read(const std::string& text, const std::string& name = "test.log") {
    CarmenLogReader reader(folder_.write(name, text));
    auto records = read_all(reader);
    report_ = reader.report();
    return records;
  }

  test::TemporaryFolder folder_;
  CarmenReport report_;
};

TEST_F(CarmenLog, ReadsFlaser) {
  const auto records = read(flaser(180, kPoses));
  ASSERT_EQ(records.size(), 1U);
  const auto& scan = std::get<CarmenScan>(records[0]);
  EXPECT_EQ(scan.ranges.size(), 180U);
  EXPECT_NEAR(scan.angle_min, -kPi / 2.0, 1e-12);
  EXPECT_NEAR(scan.angle_increment, degrees_to_radians(1.0), 1e-12);
  EXPECT_NEAR(scan.world_T_laser.x(), 1.1, 1e-12);
  EXPECT_NEAR(scan.world_T_robot.x(), 1.0, 1e-12);
  EXPECT_NEAR(to_seconds(scan.stamp.time_since_epoch()), 976052857.337530, 1e-6);
}

TEST_F(CarmenLog, ResolutionFollowsTheNumberOfBeams) {
  for (const auto& [beams, degrees] :
       {std::make_pair(180, 1.0), std::make_pair(181, 1.0), std::make_pair(360, 0.5),
        std::make_pair(361, 0.5), std::make_pair(90, 2.0), std::make_pair(91, 2.0)}) {
    const auto records = read(flaser(beams, kPoses));
    EXPECT_NEAR(std::get<CarmenScan>(records.at(0)).angle_increment, degrees_to_radians(degrees),
                1e-12)
        << beams;
  }
}

TEST_F(CarmenLog, ReadsRobotLaser) {
  const auto records = read(
      "VERTEX2 7 4 5 0.6\n"
      "ROBOTLASER1 0 -1.5 3.0 0.5 50.0 0.1 0 3 1.5 50.0 2.5 2 9 8 "
      "0.9 2 0.5 1.0 2 0.5 0.3 0.1 0 0 0 1211.5 host 0.2\n");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(std::get<CarmenVertex>(records[0]).index, 7);
  const auto& scan = std::get<CarmenScan>(records[1]);
  EXPECT_NEAR(scan.angle_min, -1.5, 1e-12);
  EXPECT_NEAR(scan.angle_increment, 0.5, 1e-12);
  EXPECT_NEAR(scan.world_T_laser.x(), 0.9, 1e-12);
  EXPECT_NEAR(scan.world_T_robot.x(), 1.0, 1e-12);
  LaserScan normalized;
  normalize(scan.raw(), {}, normalized);
  EXPECT_TRUE(normalized.valid(0));
  EXPECT_FALSE(normalized.valid(1));  // the maximum itself means that nothing returned
}

TEST_F(CarmenLog, ReadsOdom) {
  const auto records = read("ODOM 1 2 0.3 0.4 0.5 0 12.25 host 0.1\n");
  const auto& odometry = std::get<CarmenOdometry>(records.at(0));
  EXPECT_NEAR(odometry.odom_T_robot.theta(), 0.3, 1e-12);
  EXPECT_NEAR(odometry.forward_velocity, 0.4, 1e-12);
  EXPECT_NEAR(odometry.turn_velocity, 0.5, 1e-12);
  EXPECT_EQ(odometry.stamp, Time(std::chrono::milliseconds(12250)));
}

TEST_F(CarmenLog, TakesTheMaximumRangeFromTheParameters) {
  const auto records = read("PARAM robot_front_laser_max 20.5 1 host 1\n" + flaser(3, kPoses));
  EXPECT_NEAR(std::get<CarmenScan>(records.at(0)).range_max, 20.5, 1e-12);
  EXPECT_EQ(report_.other, 1U);
}

TEST_F(CarmenLog, ReadsPackedFiles) {
  const std::string text = flaser(180, kPoses) + "ODOM 1 2 0.3 0.4 0.5 0 12.25 host 0.1\n";
  for (const char* name : {"packed.log.gz", "packed.log.bz2"}) {
    EXPECT_EQ(read(text, name).size(), 2U) << name;
  }
}

TEST_F(CarmenLog, KeepsFileOrderAndCountsBackwardStamps) {
  const auto records =
      read("ODOM 1 0 0 0 0 0 12.0 h 0\nODOM 2 0 0 0 0 0 11.0 h 0\nODOM 3 0 0 0 0 0 13.0 h 0\n");
  ASSERT_EQ(records.size(), 3U);
  EXPECT_NEAR(std::get<CarmenOdometry>(records[1]).odom_T_robot.x(), 2.0, 1e-12);
  EXPECT_EQ(report_.backward_stamps, 1U);
  EXPECT_NE(describe(report_).find("1 stamps run backward"), std::string::npos);
}

TEST_F(CarmenLog, LeavesOutMalformedLinesAndNamesThem) {
  const auto records = read(
      "# comment\n"
      "FLASER 3 1.0 2.0\n"                        // cut short
      "FLASER 3 1.0 x 2.0 0 0 0 0 0 0 1.0 h 1\n"  // not a number
      "FLASER -3 1.0\n"                           // no count
      "FLASER 99999999999 1.0\n"                  // no such laser
      "FLASER 2.5 1.0 1.0\n"                      // half a beam
      "ODOM 1 2 nan 0 0 0 1.0 h 1\n"              // not finite
      "ODOM 1 2 0 0 0 0 1e300 h 1\n"              // no such time
      "FLASER\n"                                  // a word alone
      "ODOM 1 2 0 0 0 0 1.0 h 1\n");
  EXPECT_EQ(records.size(), 1U);
  EXPECT_EQ(report_.malformed_lines, (std::vector<std::size_t>{2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(report_.other, 2U);
  EXPECT_NE(describe(report_).find("7 malformed lines left out: 2 3 4 5 6 ..."), std::string::npos)
      << describe(report_);
}

TEST_F(CarmenLog, AScanWithoutBeamsIsAScan) {
  const auto records = read("FLASER 0 0 0 0 0 0 0 1.0 h 1\n");
  ASSERT_EQ(records.size(), 1U);
  LaserScan scan;
  EXPECT_FALSE(normalize(std::get<CarmenScan>(records[0]).raw(), {}, scan).usable());
}

TEST_F(CarmenLog, NamesAFileThatIsNotThere) {
  try {
    CarmenLogReader reader("/nowhere/log.clf");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/log.clf"), std::string::npos);
  }
}

TEST_F(CarmenLog, NamesADamagedFileAndTheLine) {
  std::string text;
  for (int i = 0; i < 2000; ++i) {
    text += flaser(180, std::to_string(i) + " 2 0.5 1.0 2 0.5 " + std::to_string(i) + ".5 host 0");
  }
  for (const char* name : {"cut.log.gz", "cut.log.bz2"}) {
    const std::string path = folder_.write(name, text);
    std::ifstream in(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    CarmenLogReader reader(path);
    try {
      read_all(reader);
      FAIL() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("after line"), std::string::npos) << error.what();
    }
  }
}

TEST_F(CarmenLog, NamesAFolderInsteadOfAFile) {
  EXPECT_THROW(
      {
        CarmenLogReader reader("/tmp");
        read_all(reader);
      },
      std::runtime_error);
}

}  // namespace
}  // namespace falko_slam
