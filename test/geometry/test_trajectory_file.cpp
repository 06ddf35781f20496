// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/geometry/trajectory_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "support/seeds.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

Trajectory read(const std::string& text) {
  const test::TemporaryFolder folder;
  return read_tum(folder.write("test.tum", text));
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(TrajectoryFile, IsWrittenAsTumWants) {
  EXPECT_EQ(tum_text({{Time(Duration(1216630413000000)), {1.5, -2.0, 0.0}},
                      {Time(Duration(-7)), {0.0, -0.0, 0.5 * kPi}}}),
            "# timestamp tx ty tz qx qy qz qw\n"
            "1216630.413000000 1.500000000 -2.000000000 0 0 0 0.000000000000 1.000000000000\n"
            "-0.000000007 0.000000000 0.000000000 0 0 0 0.707106781259 0.707106781114\n");
}

TEST(TrajectoryFile, ComesBackAsTheSameText) {
  auto random = test::seeded_random();
  Trajectory trajectory;
  for (const double theta : {kPi, -kPi, kPi - 1e-9, 1e-9 - kPi, 0.0, 1e-9, -1e-9, 3.0 * kPi}) {
    trajectory.push_back({Time(Duration(1)), {0.0, 0.0, theta}});
  }
  for (int i = 0; i < 1000; ++i) {
    const double x = test::uniform(random, -1e4, 1e4);
    const double theta = test::uniform(random, -kPi, kPi);
    trajectory.push_back(
        {Time(Duration(static_cast<std::int64_t>(random() / 4))), {x, -0.3 * x, theta}});
  }
  const std::string text = tum_text(trajectory);
  const Trajectory again = read(text);
  EXPECT_EQ(tum_text(again), text);
  ASSERT_EQ(again.size(), trajectory.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].stamp, trajectory[i].stamp);
    EXPECT_NEAR(again[i].map_T_base.x(), trajectory[i].map_T_base.x(), 1e-9);
    EXPECT_NEAR(angle_between(again[i].map_T_base.theta(), trajectory[i].map_T_base.theta()), 0.0,
                2e-9);
  }
}

TEST(TrajectoryFile, ReadsCommentsBlanksAndOtherWaysToWriteNumbers) {
  const Trajectory trajectory = read(
      "# a comment\n\n  # another\n1.5 1 2 9 0 0 1 0\r\n\t1e3  -1e-1 .5 0 0 0 0 -1\n2 0 0 0 1 0 0 "
      "0");
  ASSERT_EQ(trajectory.size(), 3U);
  EXPECT_EQ(trajectory[0].stamp, Time(Duration(1500000000)));
  EXPECT_NEAR(std::abs(trajectory[0].map_T_base.theta()), kPi, 1e-12);
  EXPECT_EQ(trajectory[1].stamp, Time(from_seconds(1000.0)));
  EXPECT_EQ(trajectory[1].map_T_base.x(), -0.1);
  EXPECT_NEAR(trajectory[1].map_T_base.theta(), 0.0, 1e-12);
  EXPECT_NEAR(trajectory[2].map_T_base.theta(), 0.0, 1e-12);  // upside down, not turned
}

TEST(TrajectoryFile, KeepsTheOrderOfBackwardAndRepeatedStamps) {
  const Trajectory trajectory = read("2 1 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n2 3 0 0 0 0 0 1\n");
  ASSERT_EQ(trajectory.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(trajectory[i].map_T_base.x(), static_cast<double>(i + 1));
  }
}

TEST(TrajectoryFile, ErrorsNameFileAndLine) {
  for (const char* line :
       {"1 2 3", "1 0 0 0 0 0 0 1 9", "1 0 0 0 0 0 0 one", "1 nan 0 0 0 0 0 1", "word"}) {
    const std::string error = error_of("1 0 0 0 0 0 0 1\n" + std::string(line));
    EXPECT_NE(error.find("test.tum: line 2: must be eight numbers"), std::string::npos) << error;
  }
  EXPECT_NE(error_of("1 0 0 0 0 0 0 0").find("line 1: the quaternion's length"), std::string::npos);
  for (const char* stamp : {"1e10", "-9000000001", "1.2.3", "1:2"}) {
    const std::string error = error_of(std::string(stamp) + " 0 0 0 0 0 0 1");
    EXPECT_NE(error.find("line 1: '" + std::string(stamp) + "' is no timestamp"), std::string::npos)
        << error;
  }
  EXPECT_THROW(read_tum("/nowhere/file.tum"), std::runtime_error);
}

TEST(TimeOf, IsExactToTheNanosecond) {
  EXPECT_EQ(time_of("976052890.235301123"), Time(Duration(976052890235301123)));
  EXPECT_EQ(time_of("976052890.235301"), Time(Duration(976052890235301000)));
  EXPECT_EQ(time_of("-0.5"), Time(Duration(-500000000)));
  EXPECT_EQ(time_of("+7"), Time(Duration(7000000000)));
  EXPECT_EQ(time_of(".25"), Time(Duration(250000000)));
  EXPECT_EQ(time_of("1.9999999996"), Time(Duration(2000000000)));
  EXPECT_EQ(time_of("1.25e1"), Time(Duration(12500000000)));
}

}  // namespace
}  // namespace falko_slam
