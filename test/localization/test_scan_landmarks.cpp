// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/scan_landmarks.hpp"

#include <gtest/gtest.h>

#include "localization/localizer_drive.hpp"

namespace falko_slam {
namespace {

// On a vehicle that drives, what a scan shows is where the laser saw it in the middle of the scan.
TEST(LandmarkDetector, FreesReflectorsFromTheMotionOfTheScan) {
  const test::LocalizerDrive& drive = test::LocalizerDrive::shared();
  LocalizerParams params;
  params.base_T_laser = drive.localizer(drive.map()).params().base_T_laser;
  LandmarkDetector detector(params, drive.map());
  OdometryTrack track(std::chrono::seconds(2));
  std::size_t near = 0, seen = 0;
  for (const DriveInputEvent& event : drive.events()) {
    if (event.stamp > drive.at(10.0)) break;
    if (event.motion) track.add(event.stamp, *event.motion);
    if (!event.scan || track.empty()) continue;
    const ScanLandmarks found = detector.detect(*event.scan, track);
    const Pose2 map_T_laser = drive.truth(found.instant) * params.base_T_laser;
    for (const TimedObservation& timed : found.seen) {
      const Eigen::Vector2d point = map_T_laser * point_in_laser(timed.observation);
      ++seen;
      for (const MapLandmark& landmark : drive.map().landmarks) {
        if ((landmark.position - point).norm() < 0.05) ++near;
      }
    }
    EXPECT_TRUE(found.instant > event.scan->first_beam_time);
  }
  EXPECT_GT(seen, 200U);
  EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(seen));
}

TEST(LandmarkDetector, SaysWhyThereAreNoReflectors) {
  const test::LocalizerDrive& drive = test::LocalizerDrive::shared();
  LandmarkDetector detector({}, drive.map());
  LaserScan scan;
  for (const DriveInputEvent& event : drive.events()) {
    if (event.scan) scan = *event.scan;
  }
  scan.intensities.clear();
  const ScanLandmarks found = detector.detect(scan, OdometryTrack(std::chrono::seconds(2)));
  EXPECT_TRUE(found.seen.empty());
  EXPECT_EQ(found.report.fault, IntensityFault::kMissing);
}

}  // namespace
}  // namespace falko_slam
