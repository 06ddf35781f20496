// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A real tricycle: its drive counter overflows, its steering passes the encoder's zero.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/vehicle/tricycle_log.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"
#include "support/recordings.hpp"

namespace falko_slam {
namespace {

struct Difference {
  double position = 0.0;  // [m]
  double heading = 0.0;   // [rad]

  void include(const Pose2& pose, const Pose2& expected) {
    position = std::max(position, (pose.translation() - expected.translation()).norm());
    heading = std::max(heading, std::abs(angle_between(expected.theta(), pose.theta())));
  }
};

class RecordedTricycle : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string path = test::tricycle_recording();
    if (!std::ifstream(path)) {
      GTEST_SKIP() << path << " is not there: set FALKO_SLAM_DATA to the folder that holds "
                   << "tricycle/dataset.txt";
    }
    TricycleLogReader reader(path);
    while (const auto record = reader.next()) records_.push_back(*record);
    report_ = reader.report();
    tricycle_ = tricycle_params_of(reader.header());
    encoders_ = encoder_params_of(reader.header());
  }

  std::vector<TricycleRecord> records_;
  TricycleLogReport report_;
  TricycleParams tricycle_;
  EncoderParams encoders_;
};

TEST_F(RecordedTricycle, IsReadToItsEnd) {
  EXPECT_EQ(records_.size(), 2434U);
  EXPECT_EQ(report_.other, 8U);
  EXPECT_TRUE(report_.malformed_lines.empty());
  EXPECT_EQ(report_.backward_stamps, 0U);
}

TEST_F(RecordedTricycle, ItsOdometryIsOurs) {
  TricycleOdometryParams params;
  params.max_wheel_speed = 2.5;
  TricycleOdometry odometry(tricycle_, encoders_, records_.front().odom_T_base, params);
  Difference worst;
  for (const TricycleRecord& record : records_) {
    EXPECT_NE(odometry.add(record.encoders).verdict, OdometryVerdict::kJump);
    worst.include(odometry.odom_T_base(), record.odom_T_base);
  }
  EXPECT_LT(worst.position, 0.0095);
  EXPECT_LT(worst.heading, 0.0016);
}

// What is left is not ours: the vehicle steered each arc by the reading at its end.
TEST_F(RecordedTricycle, ItsOdometryIsOursToTheDigitsOfTheLogIfSteeredByTheArcsEnd) {
  Pose2 odom_T_base = records_.front().odom_T_base;
  Difference worst;
  for (std::size_t i = 1; i < records_.size(); ++i) {
    const EncoderReading& now = records_[i].encoders;
    const auto ticks = ticks_between(records_[i - 1].encoders.drive_ticks, now.drive_ticks);
    odom_T_base =
        odom_T_base * drive_arc(tricycle_, ticks, steering_of(encoders_, now.steer_ticks));
    worst.include(odom_T_base, records_[i].odom_T_base);
  }
  EXPECT_LT(worst.position, 1e-4);
  EXPECT_LT(worst.heading, 1e-5);
}

}  // namespace
}  // namespace falko_slam
