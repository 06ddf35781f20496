// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The core of the SLAM's callbacks: a drive round the office whose inputs are broken.
#include "falko_slam/slam/feature_slam.hpp"

#include "falko_slam/slam/slam_record.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"
#include "fuzz/input_scan.hpp"
#include "support/slam_drive.hpp"

namespace falko_slam {
namespace fuzz {
namespace {

constexpr int kMostSlamScans = 24;

const std::vector<SlamScan>& office_drive() {
  static const std::vector<SlamScan> drive = [] {
    std::vector<SlamScan> scans;
    auto random = test::seeded_random();
    const Scene scene = office_scene();
    for (const Pose2& pose : office_path(0.25)) {
      SlamScan scan;
      scan.stamp = Time(from_seconds(100.0 + 0.125 * static_cast<double>(scans.size())));
      scan.odom_T_base = pose;
      scan.base_T_laser = test::kDriveMount;
      scan.scan = test::closed_scan(scene, pose * test::kDriveMount, 180, 0.01, random);
      scans.push_back(scan);
    }
    return scans;
  }();
  return drive;
}

// A pose as tf may bring it: any number that is one.
Pose2 any_pose(InputNumbers& numbers) {
  constexpr double kSizes[] = {1.0, 1.0, 1e5, 1e12, 1e300};
  const double size = kSizes[numbers.below(5)];
  return {numbers.within(size), numbers.within(size), numbers.within(kPi)};
}

SlamScan changed_scan(SlamScan scan, InputNumbers& numbers) {
  switch (numbers.below(5)) {
    case 0:
      scan.odom_T_base = any_pose(numbers);
      break;
    case 1:
      scan.base_T_laser = any_pose(numbers);
      break;
    case 2:
      scan.stamp = any_stamp(numbers);
      break;
    case 3:
      normalize(any_scan(numbers, 180).raw(), {}, scan.scan);
      break;
    default:
      scan.odom_T_base.reset();
      break;
  }
  return scan;
}

void propose(FeatureSlam& slam, InputNumbers& numbers) {
  const KeyframeId target{numbers.below(30)}, source{numbers.below(30)};
  const PoseEstimate pose{any_pose(numbers), pose_covariance(numbers.within(1.0), 0.1)};
  try {
    slam.propose(target, source, pose);
  } catch (const std::invalid_argument&) {  // not there, or no estimate
  }
}

void draw(const FeatureSlam& slam) {
  try {
    map_of(slam);
  } catch (const std::invalid_argument&) {  // a pose farther away than any map
  } catch (const std::runtime_error&) {     // more cells than any map has
  }
}

}  // namespace

void fuzz_slam(const std::string& input) {
  InputNumbers numbers(input);
  FeatureSlam slam;
  std::size_t at = 0;
  for (int scans = 0; !numbers.ended() && scans < kMostSlamScans;) {
    const SlamScan& scan = office_drive()[at % office_drive().size()];
    switch (numbers.below(8)) {
      case 0:
        slam.begin_drive();
        break;
      case 1:
        slam.finish();
        break;
      case 2:
        propose(slam, numbers);
        break;
      case 3:
        at += numbers.any<std::uint8_t>();
        break;
      case 4:
        ++scans;
        slam.add(changed_scan(scan, numbers));
        break;
      default:
        ++scans;
        ++at;
        slam.add(scan);
        break;
    }
  }
  slam.finish();
  draw(slam);
  for (const GraphNode& node : slam.graph().nodes) {
    require(node.map_T_node.translation().allFinite(), "poses are finite");
  }
}

}  // namespace fuzz
}  // namespace falko_slam
