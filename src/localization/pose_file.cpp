// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "covariance_check.hpp"
#include "falko_slam/common/bytes.hpp"
#include "falko_slam/common/number_text.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "falko_slam/common/yaml_fields.hpp"
#include "falko_slam/geometry/trajectory_file.hpp"
#include "landmark_fields.hpp"

namespace falko_slam {
namespace {

constexpr int kPoseVersion = 1;

// The upper half of a symmetric 3 x 3 matrix, row by row.
std::string upper_half(const Eigen::Matrix3d& matrix) {
  std::string text;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = row; column < 3; ++column) {
      text += (text.empty() ? "" : ", ") + exact_text(matrix(row, column));
    }
  }
  return "[" + text + "]";
}

Eigen::Matrix3d from_upper_half(const std::vector<double>& numbers) {
  Eigen::Matrix3d matrix;
  std::size_t i = 0;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = row; column < 3; ++column) {
      matrix(row, column) = matrix(column, row) = numbers[i++];
    }
  }
  return matrix;
}

bool is_usable_pose(const PoseEstimate& estimate) {
  const Pose2& pose = estimate.pose;
  const bool placed = std::abs(pose.x()) <= kFarthestLandmark &&
                      std::abs(pose.y()) <= kFarthestLandmark && std::isfinite(pose.theta());
  return placed && is_positive_semidefinite<3>(estimate.covariance);
}

std::string stamp_text(Time stamp) {
  const std::int64_t count = stamp.time_since_epoch().count();
  char text[32];
  std::snprintf(text, sizeof text, "%lld.%09lld", static_cast<long long>(count / 1000000000),
                static_cast<long long>(count % 1000000000));
  return text;
}

}  // namespace

std::string identity_of(const LandmarkMap& map) {
  std::vector<std::string> lines;
  for (const MapLandmark& landmark : map.landmarks) {
    lines.push_back(std::to_string(landmark.id) + " " + exact_text(landmark.position.x()) + " " +
                    exact_text(landmark.position.y()) + "\n");
  }
  std::sort(lines.begin(), lines.end());
  std::string all;
  for (const std::string& line : lines) all += line;
  char text[64];
  std::snprintf(text, sizeof text, "%zu landmarks, %08x", lines.size(), checksum(all, all.size()));
  return text;
}

void write_saved_pose(const std::string& path, const SavedPose& saved) {
  if (!is_usable_pose(saved.map_T_base)) {
    throw std::invalid_argument(path + ": the pose to be saved is none, or has no covariance");
  }
  const Pose2& pose = saved.map_T_base.pose;
  write_whole_file(path,
                   "# Where base_link was last in the map [m], [rad]; covariance: xx, xy, xt, yy, "
                   "yt, tt.\nsaved_pose_version: " +
                       std::to_string(kPoseVersion) + "\nmap: \"" + saved.map + "\"\nstamp: \"" +
                       stamp_text(saved.stamp) + "\"\npose: [" + exact_text(pose.x()) + ", " +
                       exact_text(pose.y()) + ", " + exact_text(pose.theta()) + "]\ncovariance: " +
                       upper_half(saved.map_T_base.covariance) + "\ncomplete: true\n");
}

SavedPose read_saved_pose(const std::string& path) {
  const YamlFields file(path);
  file.at("saved_pose_version").integer(kPoseVersion, kPoseVersion);
  SavedPose saved;
  saved.map = file.at("map").text();
  const YamlValue stamp = file.at("stamp");
  const auto time = time_of(stamp.text());
  if (!time) stamp.fail("must be a time in seconds");
  saved.stamp = *time;
  const auto pose = file.at("pose").numbers(3, {-kFarthestLandmark, kFarthestLandmark});
  const YamlValue covariance = file.at("covariance");
  saved.map_T_base = {{pose[0], pose[1], pose[2]}, from_upper_half(covariance.numbers(6))};
  if (!is_usable_pose(saved.map_T_base)) {
    covariance.fail("must be the upper half of a positive semidefinite matrix");
  }
  if (!file.at("complete").flag()) file.at("complete").fail("must be true");
  file.refuse_unknown();
  return saved;
}

std::string objection_to(const SavedPose& pose, const std::string& map, Time now,
                         Duration max_age) {
  if (pose.map != map) return "it is of another map: " + pose.map + ", not " + map;
  const double age = to_seconds(now - pose.stamp);
  if (age < 0.0) return "it is from the future, by " + fixed_text(-age, 1) + " s";
  if (now - pose.stamp > max_age) {
    return "it is " + fixed_text(age, 1) + " s old, more than " +
           fixed_text(to_seconds(max_age), 1) + " s";
  }
  return "";
}

}  // namespace falko_slam
