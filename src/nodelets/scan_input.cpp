// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_input.hpp"

#include <utility>

#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"

namespace falko_slam {
namespace {

// Of scans that wait for transforms: the more, the later it is told that these are missing.
constexpr std::uint32_t kWaiting = 20;
constexpr std::uint32_t kScanQueue = 100;
constexpr double kAftermath = 10.0;      // of a jump of time [s]
constexpr double kClockTolerance = 1.0;  // time may step back by this [s]

double steady_now() { return ros::SteadyTime::now().toSec(); }

}  // namespace

ScanInput::ScanInput(const ros::NodeHandle& node, const ScanInputParams& params, Listener listener)
    : params_(params),
      listener_(std::move(listener)),
      poses_(buffer_, params.odom_frame, params.base_frame) {
  connect(node);
}

ScanInput::~ScanInput() {
  // Nothing may come in while members go.
  scans_.unsubscribe();
  tf_.reset();  // its thread calls the filter
  filter_.reset();
}

void ScanInput::connect(ros::NodeHandle node) {
  using Filter = tf2_ros::MessageFilter<sensor_msgs::LaserScan>;
  using Callback = boost::function<void(const Message&)>;
  buffer_.setUsingDedicatedThread(true);
  tf_ = std::make_unique<tf2_ros::TransformListener>(buffer_);
  if (params_.use_odometry) {
    filter_ = std::make_unique<Filter>(buffer_, "", kWaiting, node);
    filter_->setTargetFrames(poses_.frames());
    filter_->registerCallback(Callback([this](const Message& message) { on_placed(message); }));
    filter_->registerFailureCallback(
        [this](const Message& message, auto /*reason*/) { on_dropped(message); });
  }
  scans_.registerCallback(Callback([this](const Message& message) { on_received(message); }));
  scans_.subscribe(node, topics::kScan, kScanQueue);
}

void ScanInput::watch_time() {
  const ros::Time now = ros::Time::now();
  const double back = last_time_.toSec() - now.toSec();
  last_time_ = now;
  if (back > kClockTolerance) {
    jumped_ = steady_now();
    // What waits for transforms of the time before would wait until that time comes again.
    if (filter_) filter_->clear();
    listener_.time_has_jumped(back);
  }
  forget_the_future();
}

void ScanInput::forget_the_future() {
  if (!params_.use_odometry || steady_now() - jumped_ > kAftermath) return;
  const auto newest = poses_.newest(last_frame_);
  if (newest && *newest > ros::Time::now() + ros::Duration(kClockTolerance)) buffer_.clear();
}

void ScanInput::on_received(const Message& message) {
  watch_time();
  LaserScan scan;
  const ScanReport report = normalize(as_raw_scan(*message), params_.scan, scan);
  listener_.received(report);
  if (!report.usable()) return;
  last_frame_ = message->header.frame_id;
  if (filter_) {
    filter_->add(message);
  } else {
    on_placed(message);
  }
}

void ScanInput::on_dropped(const Message& message) {
  const std::string laser = tf_frame(message->header.frame_id);
  std::string missing = laser.empty() ? "it names no frame" : "";
  for (const std::string& frame : poses_.frames()) {
    std::string reason;
    if (!missing.empty() || buffer_.canTransform(frame, laser, message->header.stamp, &reason)) {
      continue;
    }
    missing = "no transform from " + laser + " to " + frame + " at its stamp: " + reason;
  }
  forget_the_future();
  listener_.dropped(missing.empty() ? "the transform came too late" : missing);
}

const LaserPlace& ScanInput::mount_of(const std::string& frame) {
  const auto known = mounts_.find(frame);
  if (known != mounts_.end()) return known->second;
  return mounts_[frame] = poses_.mount(frame);
}

SlamScan ScanInput::placed(const sensor_msgs::LaserScan& message) {
  const std::string& frame = message.header.frame_id;
  const LaserPlace& place = mount_of(frame);
  SlamScan result;
  result.stamp = from_ros(message.header.stamp);
  result.base_T_laser = place.base_T_laser;
  if (params_.use_odometry) {
    result.odom_T_base = poses_.at(frame, message.header.stamp) * place.base_T_laser.inverse();
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
