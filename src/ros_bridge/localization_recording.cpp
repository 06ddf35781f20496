// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/localization_recording.hpp"

#include <falko_slam/ReflectorArray.h>
#include <falko_slam/TricycleEncoders.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/exception.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/exceptions.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/laser_pose.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/time_conversion.hpp"
#include "falko_slam/vehicle/tricycle_odometry.hpp"
#include "recorded_tf.hpp"
#include "recording_topics.hpp"

namespace falko_slam {
namespace {

// What a device reports of a reflector: distance and direction each with a figure of their own.
constexpr double kReportedRange = 0.008, kReportedBearing = 1e-3;  // [m], [rad]

struct Topics {
  std::string motion, seen;
};

Topics topics_of(const rosbag::Bag& bag, const std::string& path,
                 const LocalizationRecordingParams& params) {
  Topics topics;
  topics.motion = params.calibration ? topic_of_type(bag, path, kEncoderType, params.encoders)
                                     : topic_of_type(bag, path, kOdometryType, params.odometry);
  topics.seen = params.reported ? topic_of_type(bag, path, kReflectorType, params.reflectors)
                                : topic_of_type(bag, path, kScanType, params.scans);
  return topics;
}

Pose2 pose_of(const geometry_msgs::Pose& pose) {
  geometry_msgs::Transform transform;
  transform.translation.x = pose.position.x;
  transform.translation.y = pose.position.y;
  transform.rotation = pose.orientation;
  return in_plane(transform);
}

// Of a vehicle of the default wheelbase: what its wheel did to move so.
Eigen::Matrix3d covariance_of(const Pose2& motion, const OdometryNoise& noise) {
  const TricycleParams tricycle;
  const Eigen::Vector3d tangent = motion.log();
  const double steering = std::atan2(tricycle.wheelbase * tangent.z(), std::abs(tangent.x()));
  const double way = std::hypot(tangent.x(), tricycle.wheelbase * tangent.z());
  const double ticks = std::copysign(way / tricycle.driving_scale, tangent.x());
  return arc_covariance(tricycle, ticks, tangent.x() < 0.0 ? -steering : steering, noise);
}

// Turns messages into motions.
class MotionReader {
 public:
  explicit MotionReader(const LocalizationRecordingParams& params)
      : tricycle_(params.calibration ? params.calibration->tricycle : TricycleParams()),
        noise_(params.noise),
        odometry_(tricycle_, gained(params)) {}

  std::optional<std::pair<Time, PoseEstimate>> add(const TricycleEncoders& message) {
    const EncoderReading reading = from_message(message);
    const Pose2 before = odometry_.odom_T_base();
    const OdometryStep step = odometry_.add(reading);
    if (step.verdict != OdometryVerdict::kIntegrated) return std::nullopt;
    return std::make_pair(
        reading.stamp, PoseEstimate{before.inverse() * odometry_.odom_T_base(),
                                    arc_covariance(tricycle_, step.ticks, step.steering, noise_)});
  }

  std::optional<std::pair<Time, PoseEstimate>> add(const nav_msgs::Odometry& message) {
    const Pose2 pose = pose_of(message.pose.pose);
    const std::optional<Pose2> before = last_;
    last_ = pose;
    if (!before) return std::nullopt;
    const Pose2 motion = before->inverse() * pose;
    return std::make_pair(from_ros(message.header.stamp),
                          PoseEstimate{motion, covariance_of(motion, noise_)});
  }

 private:
  static EncoderParams gained(const LocalizationRecordingParams& params) {
    EncoderParams counters = params.counters;
    if (params.calibration) counters.steer_gain *= params.calibration->steer_gain;
    return counters;
  }

  TricycleParams tricycle_;
  OdometryNoise noise_;
  TricycleOdometry odometry_;
  std::optional<Pose2> last_;
};

std::vector<LandmarkObservation> observations_of(const ReflectorArray& message) {
  const Eigen::Vector2d deviation(kReportedRange, kReportedBearing);
  std::vector<LandmarkObservation> observations;
  for (const Reflector& reflector : message.reflectors) {
    observations.push_back({ObservationModel::kRangeBearing,
                            {reflector.range, reflector.bearing},
                            deviation.cwiseAbs2().asDiagonal(),
                            {}});
  }
  return observations;
}

// The array's stamp is that of the first beam and its reflectors are seen up to a revolution
// later: the middle of them is the best single time.
Time middle_of(const ReflectorArray& message) {
  Duration sum{};
  for (const Reflector& reflector : message.reflectors) {
    sum += std::chrono::nanoseconds(reflector.time_offset.toNSec());
  }
  const auto count = static_cast<Duration::rep>(message.reflectors.size());
  return from_ros(message.header.stamp) + (count > 0 ? sum / count : Duration::zero());
}

void read_truth(const rosbag::Bag& bag, const std::string& wanted, Trajectory& truth) {
  for (const auto& [topic, type] : topic_types(bag)) {
    if (type != "geometry_msgs/PoseStamped" || !is_wanted(topic, wanted)) continue;
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    for (const rosbag::MessageInstance& instance : view) {
      const auto message = instance.instantiate<geometry_msgs::PoseStamped>();
      if (message) truth.push_back({from_ros(message->header.stamp), pose_of(message->pose)});
    }
  }
}

void read_mount(const rosbag::Bag& bag, const Topics& topics,
                const LocalizationRecordingParams& params, LocalizationRecording& recording) {
  const RecordedTf tf(bag);
  const LaserPoses poses(tf.buffer(), "", params.base_frame);
  rosbag::View view(bag, rosbag::TopicQuery(topics.seen));
  try {
    for (const rosbag::MessageInstance& instance : view) {
      std::string frame;
      if (const auto scan = instance.instantiate<sensor_msgs::LaserScan>()) {
        frame = scan->header.frame_id;
      } else if (const auto seen = instance.instantiate<ReflectorArray>()) {
        frame = seen->header.frame_id;
      }
      const LaserPlace place = poses.mount(frame);
      recording.base_T_laser = place.base_T_laser;
      recording.upside_down = place.upside_down.value_or(false);
      break;
    }
  } catch (const tf2::TransformException&) {
    recording.laser_known = params.calibration.has_value();
  }
  if (params.calibration) recording.base_T_laser = params.calibration->base_T_laser;
}

Time first_stamp(const rosbag::Bag& bag, const std::string& topic) {
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  for (const rosbag::MessageInstance& instance : view) {
    if (const auto encoders = instance.instantiate<TricycleEncoders>()) {
      return from_ros(encoders->header.stamp);
    }
    if (const auto odometry = instance.instantiate<nav_msgs::Odometry>()) {
      return from_ros(odometry->header.stamp);
    }
  }
  return {};
}

void play(const rosbag::Bag& bag, const Topics& topics, const LocalizationRecordingParams& params,
          const LocalizationListener& listener) {
  MotionReader motions(params);
  const auto pass_on = [&](const std::optional<std::pair<Time, PoseEstimate>>& motion) {
    if (motion) listener.motion(motion->first, motion->second);
  };
  rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{topics.motion, topics.seen}));
  for (const rosbag::MessageInstance& instance : view) {
    if (const auto encoders = instance.instantiate<TricycleEncoders>()) {
      pass_on(motions.add(*encoders));
    } else if (const auto odometry = instance.instantiate<nav_msgs::Odometry>()) {
      pass_on(motions.add(*odometry));
    } else if (const auto scan = instance.instantiate<sensor_msgs::LaserScan>()) {
      listener.scan(as_raw_scan(*scan));
    } else if (const auto seen = instance.instantiate<ReflectorArray>()) {
      listener.reflectors(middle_of(*seen), observations_of(*seen));
    }
  }
}

}  // namespace

LocalizationRecording open_localization_recording(const std::string& bag,
                                                  const LocalizationRecordingParams& params) {
  try {
    const rosbag::Bag file(bag);
    const Topics topics = topics_of(file, bag, params);
    LocalizationRecording recording;
    read_mount(file, topics, params, recording);
    recording.begin = first_stamp(file, topics.motion);
    read_truth(file, params.truth, recording.truth);
    recording.description = "motions on " + topics.motion +
                            (params.reported ? ", reflectors on " : ", scans on ") + topics.seen +
                            (recording.truth.empty() ? "" : ", with truth");
    return recording;
  } catch (const ros::Exception& error) {
    throw std::runtime_error(bag + ": " + error.what());
  }
}

void play_localization_recording(const std::string& bag, const LocalizationRecordingParams& params,
                                 const LocalizationListener& listener) {
  try {
    const rosbag::Bag file(bag);
    play(file, topics_of(file, bag, params), params, listener);
  } catch (const ros::Exception& error) {
    throw std::runtime_error(bag + ": " + error.what());
  }
}

}  // namespace falko_slam
