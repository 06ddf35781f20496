// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_input.hpp"

#include <utility>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "node_constants.hpp"

namespace falko_slam {
namespace {

// Of scans that wait for transforms: the more, the later it is told that these are missing.
constexpr std::uint32_t kWaiting = 20;

}  // namespace

ScanInput::ScanInput(const ros::NodeHandle& node, const ScanInputParams& params, Listener listener)
    : params_(params),
      listener_(std::move(listener)),
      filter_(
          node, params.odom_frame, params.base_frame, kWaiting,
          {[this](const Message& message) { on_placed(message); },
           [this](const Message&, const std::string& missing) { listener_.dropped(missing); }}) {
  scans_.registerCallback(boost::function<void(const Message&)>(
      [this](const Message& message) { on_received(message); }));
  ros::NodeHandle of_scans(node);
  scans_.subscribe(of_scans, topics::kScan, kQueue);
}

void ScanInput::watch_time() {
  const double back = filter_.watch_time();
  if (back > 0.0) listener_.time_has_jumped(back);
}

void ScanInput::on_received(const Message& message) {
  watch_time();
  LaserScan scan;
  const ScanReport report = normalize(as_raw_scan(*message), params_.scan, scan);
  listener_.received(report);
  if (!report.usable()) return;
  if (params_.use_odometry) {
    filter_.add(message);
  } else {
    on_placed(message);
  }
}

const LaserPlace& ScanInput::mount_of(const std::string& frame) {
  const auto known = mounts_.find(frame);
  if (known != mounts_.end()) return known->second;
  return mounts_[frame] = filter_.poses().mount(frame);
}

SlamScan ScanInput::placed(const sensor_msgs::LaserScan& message) {
  const std::string& frame = message.header.frame_id;
  const LaserPlace& place = mount_of(frame);
  SlamScan result;
  result.stamp = from_ros(message.header.stamp);
  result.base_T_laser = place.base_T_laser;
  if (params_.use_odometry) {
    result.odom_T_base =
        filter_.poses().at(frame, message.header.stamp) * place.base_T_laser.inverse();
  }
  ScanNormalizerParams params = params_.scan;
  params.upside_down = place.upside_down.value_or(params.upside_down);
  normalize(as_raw_scan(message), params, result.scan);
  return result;
}

void ScanInput::on_placed(const Message& message) {
  try {
    SlamScan scan = placed(*message);
    for (const BeamStatus status : scan.scan.status) {
      if (status == BeamStatus::kValid) return listener_.placed(std::move(scan));
    }
  } catch (const tf2::TransformException& error) {
    listener_.dropped(error.what());
  }
}

}  // namespace falko_slam
