// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "falko_slam/slam/feature_slam.hpp"
#include "support/drives.hpp"

namespace falko_slam {
namespace test {

/// Where the laser of these drives sits.
inline const Pose2 kLaserMount(0.3, 0.05, 0.1);

/// What SLAM is given, and where the vehicle was.
struct SlamInput {
  SlamScan scan;
  Pose2 world_T_base;
};
using SlamDrive = std::vector<SlamInput>;

inline Time scan_time(std::size_t scan) {
  return Time(std::chrono::seconds(1000) +
              static_cast<Duration::rep>(scan) * std::chrono::milliseconds(125));
}

/// With a closed laser, noise of 1 cm, 8 Hz and an odometry without error, in the world's frame.
inline SlamDrive slam_drive(const Scene& scene, const Poses& path, std::mt19937_64& random,
                            std::size_t beams = 360) {
  SlamDrive drive;
  for (const Pose2& pose : path) {
    SlamScan scan{scan_time(drive.size()), {}, pose, kLaserMount};
    scan.scan = closed_scan(scene, pose * kLaserMount, beams, 0.01, random);
    drive.push_back({std::move(scan), pose});
  }
  return drive;
}

/// The odometry goes on with `error` of each true step.
inline void mistake_steps(SlamDrive& drive, const std::function<Pose2(const Pose2&)>& error) {
  Pose2 odom = drive.front().world_T_base;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    if (i > 0) odom = odom * error(drive[i - 1].world_T_base.inverse() * drive[i].world_T_base);
    drive[i].scan.odom_T_base = odom;
  }
}

/// 2 % too long, turning by 0.01 rad/m, with noise of heading and way.
inline void let_drift(SlamDrive& drive, std::mt19937_64& random) {
  mistake_steps(drive, [&](const Pose2& step) {
    const double way = step.translation().norm();
    const double spread = std::sqrt(way);
    return Pose2((1.02 + normal(random, 0.02)) * step.translation(),
                 step.theta() + 0.01 * way + normal(random, 0.008) * spread);
  });
}

/// Without any odometry, or with one that began elsewhere.
inline void forget_odometry(SlamDrive& drive) {
  for (SlamInput& input : drive) input.scan.odom_T_base.reset();
}
inline void begin_odometry_at(SlamDrive& drive, const Pose2& start) {
  const Pose2 moved = start * drive.front().scan.odom_T_base->inverse();
  for (SlamInput& input : drive) input.scan.odom_T_base = moved * *input.scan.odom_T_base;
}

/// The steps of all scans.
inline std::vector<SlamStep> run(FeatureSlam& slam, const SlamDrive& drive) {
  std::vector<SlamStep> steps;
  for (const SlamInput& input : drive) steps.push_back(slam.add(input.scan));
  return steps;
}

inline double distance(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm();
}

/// How far odometry ends from the truth [m].
inline double greatest_odometry_error(const SlamDrive& drive) {
  double worst = 0.0;
  for (const SlamInput& input : drive) {
    worst = std::max(worst, distance(*input.scan.odom_T_base, input.world_T_base));
  }
  return worst;
}

/// How far the vehicle is from the truth at worst, with keyframes where they are now [m].
inline double greatest_error(const FeatureSlam& slam, const std::vector<SlamStep>& steps,
                             const SlamDrive& drive) {
  double worst = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Pose2 found = steps[i].keyframe
                            ? slam.map_T_laser(*steps[i].keyframe) * steps[i].keyframe_T_base
                            : steps[i].map_T_base;
    worst = std::max(worst, distance(found, drive[i].world_T_base));
  }
  return worst;
}

/// Accepted closures farther from the truth than 0.3 m or 0.1 rad; `truth` of all keyframes.
inline std::size_t false_closures(const FeatureSlam& slam, const Poses& truth) {
  std::size_t count = 0;
  for (const SlamClosure& closure : slam.closures()) {
    if (!closure.accepted) continue;
    const Pose2 expected = truth[closure.target.value].inverse() * truth[closure.source.value];
    const Pose2 error = expected.inverse() * closure.target_T_source;
    if (error.translation().norm() > 0.3 || std::abs(error.theta()) > 0.1) ++count;
  }
  return count;
}

/// Where the lasers of the keyframes were.
inline Poses keyframe_truth(const std::vector<SlamStep>& steps, const SlamDrive& drive) {
  Poses truth;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].is_keyframe) {
      truth.push_back(drive[i].world_T_base * drive[i].scan.base_T_laser);
    }
  }
  return truth;
}

}  // namespace test
}  // namespace falko_slam
