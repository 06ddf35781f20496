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
  EXPECT_TRUE(result.says("odometry of the whole drive: mean error 0.2")) << result.output;
  EXPECT_TRUE(result.says("tied to each other: ")) << result.output;
}

}  // namespace
}  // namespace falko_slam
