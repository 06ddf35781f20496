// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/scene_memory.hpp"

#include <gtest/gtest.h>

#include "localization/scan_of_room.hpp"

namespace falko_slam {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(125);

class SceneMemoryTest : public ::testing::Test {
 protected:
  // The share after a motion that the track knows, then a scan.
  std::optional<double> share_after(const Pose2& motion, const LaserScan& scan) {
    now_ += kPeriod;
    track_.add(now_, {motion, {}});
    return memory_.share_seen_again(scan, now_, track_);
  }

  const Scene room_ = test::room_with_box();
  const Pose2 mount_{0.3, 0.1, 0.2};
  OdometryTrack track_{std::chrono::seconds(2)};
  SceneMemory memory_{mount_};
  Time now_{std::chrono::seconds(100)};
};

TEST_F(SceneMemoryTest, SeesTheSameRoomAgainFromAnotherPlace) {
  const Pose2 motion(0.2, 0.0, 0.1);

  EXPECT_FALSE(share_after({}, test::scan_of(room_, mount_)));
  const auto share = share_after(motion, test::scan_of(room_, motion * mount_));

  ASSERT_TRUE(share);
  EXPECT_GT(*share, 0.95);
}

TEST_F(SceneMemoryTest, SeesThatTheVehicleWasCarried) {
  share_after({}, test::scan_of(room_, mount_));
  const auto share = share_after({}, test::scan_of(room_, Pose2(-3.0, -1.5, 1.0) * mount_));

  ASSERT_TRUE(share);
  EXPECT_LT(*share, 0.5);
}

TEST_F(SceneMemoryTest, ForgetsWhatIsOld) {
  const LaserScan scan = test::scan_of(room_, mount_);
  share_after({}, scan);
  now_ += std::chrono::seconds(3);
  EXPECT_FALSE(share_after({}, scan));
  memory_.clear();
  EXPECT_FALSE(share_after({}, scan));
  EXPECT_TRUE(share_after({}, scan));
}

// They have no bearings to compare, and an increment of zero to divide by.
TEST_F(SceneMemoryTest, SaysNothingOfScansOfOneBeamOrNone) {
  share_after({}, test::scan_of(room_, mount_));
  LaserScan one;
  one.ranges = {2.0};
  one.status = {BeamStatus::kValid};
  EXPECT_FALSE(share_after({}, one));
  EXPECT_FALSE(share_after({}, LaserScan{}));
  EXPECT_FALSE(share_after({}, test::scan_of(room_, mount_)));
}

}  // namespace
}  // namespace falko_slam
