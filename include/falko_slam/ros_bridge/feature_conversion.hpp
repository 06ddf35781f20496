// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <falko_slam/FeatureArray.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "falko_slam/features/feature_extractor.hpp"

namespace falko_slam {

/// The features of the extractor's last scan, in the frame of its message: for a laser that hangs
/// upside down y and angles change sign.
FeatureArray to_message(const FeatureExtractor& extractor, const std_msgs::Header& header);

/// For rviz: all keypoints as one SPHERE_LIST ("keypoints"), their orientations as one LINE_LIST
/// ("orientations"). They vanish after a second without a successor.
visualization_msgs::MarkerArray to_markers(const FeatureArray& features);

/// The keypoints as x, y, z [m] and intensity, which is their roughness: a pcl::PointXYZI each.
sensor_msgs::PointCloud2 to_cloud(const FeatureArray& features);

}  // namespace falko_slam
