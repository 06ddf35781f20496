// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/drive_recording.hpp"

#include <ros/exception.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/exceptions.h>

#include <stdexcept>
#include <variant>

#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/sensor/carmen_log.hpp"
#include "recorded_tf.hpp"
#include "recording_topics.hpp"

namespace falko_slam {
namespace {

using Use = std::function<void(const RecordedScan&)>;

class BagDrive {
 public:
  BagDrive(const rosbag::Bag& bag, const DriveRecordingParams& params)
      : tf_(bag), params_(params), poses_(tf_.buffer(), params.odom_frame, params.base_frame) {}

  RecordedScan recorded(const sensor_msgs::LaserScan& message, DriveRecordingReport& report) const {
    RecordedScan scan;
    scan.raw = as_raw_scan(message);
    try {
      const LaserPlace place = poses_.mount(message.header.frame_id);
      scan.base_T_laser = place.base_T_laser;
      scan.upside_down = place.upside_down.value_or(false);
    } catch (const tf2::TransformException&) {
      report.base_known = false;
    }
    if (params_.use_odometry) scan.odom_T_base = odometry(message, scan.base_T_laser);
    ++report.scans;
    if (!scan.odom_T_base) ++report.without_odometry;
    return scan;
  }

 private:
  std::optional<Pose2> odometry(const sensor_msgs::LaserScan& message,
                                const Pose2& base_T_laser) const {
    try {
      return poses_.at(message.header.frame_id, message.header.stamp) * base_T_laser.inverse();
    } catch (const tf2::TransformException&) {
      return std::nullopt;
    }
  }

  RecordedTf tf_;
  const DriveRecordingParams& params_;
  LaserPoses poses_;
};

DriveRecordingReport read_bag_drive(const std::string& path, const DriveRecordingParams& params,
                                    const Use& use) {
  try {
    rosbag::Bag bag(path);
    const std::string topic = scan_topic(bag, path, params.topic);
    const BagDrive drive(bag, params);
    DriveRecordingReport report;
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& instance : view) {
      const auto message = instance.instantiate<sensor_msgs::LaserScan>();
      if (message) use(drive.recorded(*message, report));
    }
    if (report.scans == 0) throw std::runtime_error(path + ": no laser scan on " + topic);
    report.description = std::to_string(report.scans) + " scans on " + topic;
    return report;
  } catch (const ros::Exception& error) {  // of the bag or of a message in it
    throw std::runtime_error(path + ": " + error.what());
  }
}

DriveRecordingReport read_log_drive(const std::string& path, const DriveRecordingParams& params,
                                    const Use& use) {
  CarmenLogReader reader(path);
  DriveRecordingReport report;
  while (const auto record = reader.next()) {
    const auto* scan = std::get_if<CarmenScan>(&*record);
    if (scan == nullptr) continue;
    RecordedScan recorded;
    recorded.raw = scan->raw();
    recorded.base_T_laser = scan->world_T_robot.inverse() * scan->world_T_laser;
    if (params.use_odometry) recorded.odom_T_base = scan->world_T_robot;
    ++report.scans;
    if (!recorded.odom_T_base) ++report.without_odometry;
    use(recorded);
  }
  report.description = describe(reader.report());
  if (report.scans == 0)
    throw std::runtime_error(path + ": no laser scan in " + report.description);
  return report;
}

}  // namespace

DriveRecordingReport read_drive(const std::string& path, const DriveRecordingParams& params,
                                const Use& use) {
  return is_bag(path) ? read_bag_drive(path, params, use) : read_log_drive(path, params, use);
}

}  // namespace falko_slam
