// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_build.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "console.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "falko_slam/localization/map_format.hpp"
#include "falko_slam/ros_bridge/drive_recording.hpp"
#include "falko_slam/ros_bridge/pose_recording.hpp"
#include "falko_slam/sensor/deskew.hpp"
#include "falko_slam/sensor/scan_normalizer.hpp"

namespace falko_slam {
namespace cli {
namespace {

constexpr Duration kMaxGap = std::chrono::seconds(1);  // between poses of a trajectory

TrajectoryIndex poses_of(const MapBuildOptions& options) {
  const bool is_file = std::filesystem::is_regular_file(options.poses);
  return TrajectoryIndex(is_file ? read_tum(options.poses)
                                 : read_pose_topic(options.bag, options.poses));
}

// A corner lies between two beams, and along them as far off as their noise: for its weight only.
Eigen::Matrix2d keypoint_covariance(const Keypoint& keypoint, double angle_increment) {
  constexpr double kNoise = 0.01;  // [m]
  const double spacing = keypoint.position.norm() * angle_increment;
  return (kNoise * kNoise + spacing * spacing / 3.0) * Eigen::Matrix2d::Identity();
}

// Where a laser is when it begins a scan, and how it moves on.
struct Sweep {
  Pose2 map_T_laser;
  LaserMotion motion;
};

// The drive's scans, freed of the motion, with their keypoints.
class CornerMapping {
 public:
  explicit CornerMapping(const MapBuildOptions& options)
      : options_(options),
        poses_(poses_of(options)),
        detector_(options.falko),
        mapper_(options.mapper) {}

  void take(const RecordedScan& recorded) {
    ScanNormalizerParams params;
    params.upside_down = recorded.upside_down;
    if (!normalize(recorded.raw, params, scan_).usable()) return;
    const auto sweep = sweep_of(recorded);
    if (!sweep) {
      ++without_pose_;
      return;
    }
    const LaserScan still = deskew(scan_, sweep->motion, recorded.raw.stamp);
    std::vector<PointEstimate> corners;
    for (const Keypoint& keypoint : detector_.detect(still)) {
      if (keypoint.position.norm() > options_.max_range) continue;
      corners.push_back({keypoint.position, keypoint_covariance(keypoint, still.angle_increment)});
    }
    mapper_.add(sweep->map_T_laser, still, corners);
  }

  FeatureMap map(const LandmarkMap& reflectors) const { return mapper_.build(reflectors); }
  std::size_t without_pose() const { return without_pose_; }

 private:
  std::optional<Sweep> sweep_of(const RecordedScan& recorded) const {
    const Time begin = recorded.raw.stamp;
    const Duration step =
        scan_.time_increment < Duration{} ? -scan_.time_increment : scan_.time_increment;
    const Duration time = step * static_cast<Duration::rep>(scan_.size());
    const auto first = poses_.interpolate(begin, kMaxGap);
    const auto last = poses_.interpolate(begin + time, kMaxGap);
    if (!first || !last) return std::nullopt;
    const Pose2 base_T_laser = options_.base_T_laser.value_or(recorded.base_T_laser);
    const Pose2 map_T_laser = *first * base_T_laser;
    return Sweep{map_T_laser, {map_T_laser.inverse() * *last * base_T_laser, time}};
  }

  const MapBuildOptions& options_;
  TrajectoryIndex poses_;
  FalkoDetector detector_;
  FeatureMapper mapper_;
  LaserScan scan_;
  std::size_t without_pose_ = 0;
};

void print(const FeatureMapReport& report, std::size_t known) {
  std::printf("%zu scans from %zu viewpoints, %zu keypoints in %zu clusters\n", report.scans,
              report.viewpoints, report.keypoints, report.clusters);
  std::printf(
      "left out: %zu seen by too few scans or viewpoints, %zu by too few of those that "
      "should have seen them, %zu too near to a better one or a reflector\n",
      report.too_few_hits, report.too_small_share, report.too_near);
  std::printf("%zu features from %zu keypoints, beside %zu landmarks that were known\n",
              report.features, report.keypoints_of_features, known);
}

nlohmann::json json_of(const FeatureMapReport& report, std::size_t without_pose) {
  return {{"scans", report.scans},
          {"without_pose", without_pose},
          {"viewpoints", report.viewpoints},
          {"keypoints", report.keypoints},
          {"clusters", report.clusters},
          {"too_few_hits", report.too_few_hits},
          {"too_small_share", report.too_small_share},
          {"too_near", report.too_near},
          {"features", report.features},
          {"keypoints_of_features", report.keypoints_of_features}};
}

}  // namespace

void build_map(const MapBuildOptions& options) {
  if (is_imk(options.out)) {
    throw std::runtime_error(options.out + ": a layout holds no corners, a .yaml does");
  }
  LandmarkMap known;
  if (!options.reflectors.empty()) known = read_map_of_any_format(options.reflectors);
  CornerMapping mapping(options);
  DriveRecordingParams params;
  params.topic = options.topic;
  params.base_frame = options.base_frame;
  params.use_odometry = false;
  DriveRecordingReport read;
  {
    Progress progress("scans");
    read = read_drive(options.bag, params, [&](const RecordedScan& scan) {
      mapping.take(scan);
      progress.step();
    });
  }
  const FeatureMap result = mapping.map(known);
  if (result.report.scans == 0) {
    throw std::runtime_error(options.bag + ": none of its scans has a pose in " + options.poses);
  }
  write_landmark_map(options.out, result.map);
  if (options.json != "-") {
    std::printf("%s: %s\n", options.bag.c_str(), read.description.c_str());
    if (!read.base_known && !options.base_T_laser) {
      std::printf("no transform tells where the laser is: it is taken for %s\n",
                  params.base_frame.c_str());
    }
    if (mapping.without_pose() > 0) std::printf("%zu scans have no pose\n", mapping.without_pose());
    print(result.report, known.landmarks.size());
    std::printf("wrote %s: %s\n", options.out.c_str(), describe_resources().c_str());
  }
  if (!options.json.empty()) {
    write_json(options.json, json_of(result.report, mapping.without_pose()));
  }
}

}  // namespace cli
}  // namespace falko_slam
