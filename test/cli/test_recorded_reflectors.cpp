// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Recordings of a Hokuyo UST-30LX and one cylinder of 45 mm radius at a measured distance, by
// Krithigha24 (Reflector-Calibration).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "falko_slam/features/reflector_detector.hpp"
#include "falko_slam/ros_bridge/scan_recording.hpp"
#include "support/recordings.hpp"

namespace falko_slam {
namespace {

struct RecordedBag {
  const char* name;
  double distance;    // [m]
  double bearing;     // [rad]
  std::size_t scans;  // at least
};

class RecordedReflectors : public ::testing::TestWithParam<RecordedBag> {};

// Only the diameter is told; all else are the defaults.
TEST_P(RecordedReflectors, AreTheOneAtItsDistanceInEveryScan) {
  const std::string path = test::reflector_folder() + GetParam().name + ".bag.gz";
  if (!std::ifstream(path))
    GTEST_SKIP() << path << " is not there; $FALKO_SLAM_DATA names a folder";
  ReflectorDetectorParams params;
  params.diameter = 0.09;
  ReflectorDetector detector(params);
  LaserScan scan;
  std::size_t scans = 0;
  read_scans(path, "", [&](const RawScan& raw) {
    normalize(raw, {}, scan);
    const std::vector<DetectedReflector> found = detector.detect(scan);
    ++scans;
    ASSERT_EQ(found.size(), 1U) << "scan " << scans;
    EXPECT_NEAR(found[0].center.norm(), GetParam().distance, 0.015) << "scan " << scans;
    EXPECT_NEAR(std::atan2(found[0].center.y(), found[0].center.x()), GetParam().bearing, 0.01);
  });
  EXPECT_GE(scans, GetParam().scans);
}

INSTANTIATE_TEST_SUITE_P(All, RecordedReflectors,
                         ::testing::Values(RecordedBag{"ref_505", 0.505, 1.579, 290},
                                           RecordedBag{"ref_1111", 1.111, 1.575, 290},
                                           RecordedBag{"bs_exp_804", 0.804, -0.006, 200},
                                           RecordedBag{"bs_exp_2000", 2.0, -0.070, 200}),
                         [](const auto& recording) { return std::string(recording.param.name); });

}  // namespace
}  // namespace falko_slam
