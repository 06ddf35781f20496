// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The calibration of a real vehicle from its log.
#include <gtest/gtest.h>

#include <fstream>

#include "support/command.hpp"
#include "support/recordings.hpp"

namespace falko_slam {
namespace {

TEST(RecordedCalibration, TellsOfADriveAndWhatIsTied) {
  const std::string log = test::tricycle_recording();
  if (!std::ifstream(log)) GTEST_SKIP() << log << " is not there: set FALKO_SLAM_DATA";
  const auto result =
      test::falko({"calibrate", log, "--standard", "--free-wheelbase", "--free-steer-gain"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::string words = "odometry of the whole drive: mean error ";
  const std::size_t at = result.output.find(words);
  ASSERT_NE(at, std::string::npos) << result.output;
  EXPECT_LT(std::stod(result.output.substr(at + words.size())), 0.25);  // nominal: 14.0 m
  EXPECT_TRUE(result.says("tied to each other: ")) << result.output;
}

}  // namespace
}  // namespace falko_slam
