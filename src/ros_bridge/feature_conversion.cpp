// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/feature_conversion.hpp"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>

#include "falko_slam/geometry/angles.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"

namespace falko_slam {
namespace {

std::vector<std::uint8_t> to_bytes(const Bsc& bsc, std::size_t cells) {
  std::vector<std::uint8_t> bytes((cells + 7) / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::uint8_t>(bsc.words[i / 8] >> (8 * (i % 8)));
  }
  return bytes;
}

visualization_msgs::Marker list_marker(const std_msgs::Header& header, const char* name,
                                       std::int32_t type, double scale) {
  constexpr double kLifetime = 1.0;
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = scale;
  marker.color.a = 1.0F;
  marker.lifetime = ros::Duration(kLifetime);
  return marker;
}

}  // namespace

FeatureArray to_message(const FeatureExtractor& extractor, const std_msgs::Header& header) {
  const DescriptorParams& grid = extractor.params().descriptor;
  const LaserScan& scan = extractor.scan();
  const bool upside_down = extractor.params().scan.upside_down;
  const Time stamp = from_ros(header.stamp);
  FeatureArray message;
  message.header = header;
  message.descriptor_radius = grid.radius;
  message.bsc_rings = static_cast<std::uint32_t>(grid.rings);
  message.sectors = static_cast<std::uint32_t>(grid.sectors);
  message.cgh_sigma = grid.cgh_sigma;
  message.upside_down = static_cast<std::uint8_t>(upside_down);
  message.features.resize(extractor.features().size());
  for (std::size_t i = 0; i < message.features.size(); ++i) {
    const DescribedKeypoint& from = extractor.features()[i];
    auto& to = message.features[i];
    const double mirror = upside_down ? -1.0 : 1.0;
    to.position.x = from.keypoint.position.x();
    to.position.y = mirror * from.keypoint.position.y();
    to.orientation = wrap_angle(mirror * from.keypoint.orientation);
    to.radius = from.keypoint.radius;
    to.score = from.keypoint.score;
    to.roughness = from.keypoint.roughness;
    to.index = static_cast<std::uint32_t>(scan.message_index(from.keypoint.beam));
    to.time_offset = to_ros(scan.beam_time(from.keypoint.beam) - stamp);
    to.bsc = to_bytes(
        from.bsc, static_cast<std::size_t>(grid.rings) * static_cast<std::size_t>(grid.sectors));
    to.cgh = from.cgh.bins;
  }
  return message;
}

visualization_msgs::MarkerArray to_markers(const FeatureArray& features) {
  auto points =
      list_marker(features.header, "keypoints", visualization_msgs::Marker::SPHERE_LIST, 0.2);
  points.color.r = 1.0F;
  points.color.g = 0.5F;
  auto axes =
      list_marker(features.header, "orientations", visualization_msgs::Marker::LINE_LIST, 0.05);
  axes.color.b = 1.0F;
  axes.color.g = 0.6F;
  for (const auto& feature : features.features) {
    points.points.push_back(feature.position);
    geometry_msgs::Point tip = feature.position;
    tip.x += feature.radius * std::cos(feature.orientation);
    tip.y += feature.radius * std::sin(feature.orientation);
    axes.points.push_back(feature.position);
    axes.points.push_back(tip);
  }
  visualization_msgs::MarkerArray markers;
  markers.markers = {points, axes};
  return markers;
}

sensor_msgs::PointCloud2 to_cloud(const FeatureArray& features) {
  constexpr auto kFloat = sensor_msgs::PointField::FLOAT32;
  sensor_msgs::PointCloud2 cloud;
  cloud.header = features.header;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(4, "x", 1, kFloat, "y", 1, kFloat, "z", 1, kFloat, "intensity", 1,
                                kFloat);
  modifier.resize(features.features.size());
  if (features.features.empty()) return cloud;  // iterators look at the first byte
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x"), y(cloud, "y"), z(cloud, "z"),
      intensity(cloud, "intensity");
  for (const auto& feature : features.features) {
    *x = static_cast<float>(feature.position.x);
    *y = static_cast<float>(feature.position.y);
    *z = static_cast<float>(feature.position.z);
    *intensity = static_cast<float>(feature.roughness);
    ++x, ++y, ++z, ++intensity;
  }
  return cloud;
}

}  // namespace falko_slam
