// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/scan_landmarks.hpp"

#include <algorithm>

#include "falko_slam/sensor/deskew.hpp"

namespace falko_slam {
namespace {

bool holds(const LandmarkMap& map, LandmarkKind kind) {
  return std::any_of(map.landmarks.begin(), map.landmarks.end(),
                     [kind](const MapLandmark& landmark) { return landmark.kind == kind; });
}

Time middle_of(const LaserScan& scan) {
  if (scan.size() == 0) return scan.first_beam_time;
  return scan.first_beam_time + scan.time_increment * static_cast<Duration::rep>(scan.size()) / 2;
}

}  // namespace

LandmarkDetector::LandmarkDetector(const LocalizerParams& params, const LandmarkMap& map)
    : base_T_laser_(params.base_T_laser),
      deskew_(params.deskew),
      features_(params.features),
      reflectors_wanted_(holds(map, LandmarkKind::kReflector)),
      corners_mapped_(holds(map, LandmarkKind::kFeature)),
      reflectors_(params.reflectors),
      corners_(params.features.falko) {}

ScanLandmarks LandmarkDetector::detect(const LaserScan& scan, const OdometryTrack& track) {
  ScanLandmarks result;
  result.instant = middle_of(scan);
  if (scan.size() == 0) return result;
  if (reflectors_wanted_) add_reflectors(scan, track, result);
  if (!corners_mapped_ && !features_.unmapped) return result;
  const LaserScan still = at_instant(scan, track, result.instant);
  add_corners(scan, still, result);
  if (!features_.unmapped) return result;
  for (const DetectedFace& face : detect_faces(still, features_.faces)) {
    result.unmapped.lines.push_back(observation_of(face));
  }
  return result;
}

Pose2 LandmarkDetector::odom_T_laser(const OdometryTrack& track, Time time) const {
  return track.at(time) * base_T_laser_;
}

void LandmarkDetector::add_reflectors(const LaserScan& scan, const OdometryTrack& track,
                                      ScanLandmarks& result) {
  result.report = reflectors_.detect(scan, found_);
  const Pose2 laser_T_odom = odom_T_laser(track, result.instant).inverse();
  for (const DetectedReflector& reflector : found_) {
    PointEstimate seen{reflector.center, reflector.covariance};
    if (deskew_) {
      const Pose2 moved = laser_T_odom * odom_T_laser(track, reflector.time);
      seen = transform({moved, Eigen::Matrix3d::Zero()}, seen);
    }
    const LandmarkObservation observation{
        ObservationModel::kCartesian, seen.point, seen.covariance, {}, LandmarkKind::kReflector};
    if (!is_usable(observation)) continue;
    result.seen.push_back({observation, result.instant - reflector.time});
  }
}

LaserScan LandmarkDetector::at_instant(const LaserScan& scan, const OdometryTrack& track,
                                       Time instant) const {
  if (!deskew_) return scan;
  const Duration sweep =
      std::chrono::abs(scan.time_increment) * static_cast<Duration::rep>(scan.size());
  const Time begin = std::min(scan.first_beam_time, scan.beam_time(scan.size() - 1));
  const Pose2 begin_T_end =
      odom_T_laser(track, begin).inverse() * odom_T_laser(track, begin + sweep);
  return falko_slam::deskew(scan, {begin_T_end, sweep}, instant);
}

void LandmarkDetector::add_corners(const LaserScan& scan, const LaserScan& still,
                                   ScanLandmarks& result) {
  corners_.detect(still, keypoints_);
  for (const Keypoint& keypoint : keypoints_) {
    if (!(keypoint.position.norm() <= features_.max_range)) continue;
    const LandmarkObservation observation{
        ObservationModel::kCartesian,
        keypoint.position,
        keypoint_covariance(still, keypoint, features_.corner_noise),
        {},
        LandmarkKind::kFeature};
    if (corners_mapped_) {
      result.seen.push_back({observation, result.instant - scan.beam_time(keypoint.beam)});
    } else {
      result.unmapped.points.push_back(observation);
    }
  }
}

}  // namespace falko_slam
