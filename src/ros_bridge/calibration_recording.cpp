// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_recording.hpp"

#include <falko_slam/ReflectorArray.h>
#include <falko_slam/TricycleEncoders.h>
#include <ros/exception.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/laser_scan_conversion.hpp"
#include "falko_slam/ros_bridge/reflector_conversion.hpp"
#include "recording_topics.hpp"

namespace falko_slam {
namespace {

bool has_topic(const rosbag::Bag& bag, const std::string& type, const std::string& wanted) {
  for (const auto& [topic, its_type] : topic_types(bag)) {
    if (its_type == type && is_wanted(topic, wanted)) return true;
  }
  return false;
}

bool shows_reflectors(const rosbag::Bag& bag, const std::string& topic, std::size_t least) {
  std::size_t enough = 0, messages = 0;
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  for (const rosbag::MessageInstance& instance : view) {
    const auto seen = instance.instantiate<ReflectorArray>();
    if (!seen) continue;
    ++messages;
    if (seen->reflectors.size() >= least) ++enough;
  }
  return messages > 0 && 2 * enough >= messages;
}

EgomotionSource source_in(const rosbag::Bag& bag, const std::string& path,
                          const CalibrationTopics& topics, std::size_t min_reflectors) {
  topic_of_type(bag, path, kEncoderType, topics.encoders);
  const bool scans = has_topic(bag, kScanType, topics.scans);
  if (!has_topic(bag, kReflectorType, topics.reflectors)) {
    if (scans) return EgomotionSource::kScans;
    throw std::runtime_error(path + ": neither " + kReflectorType + " nor " + kScanType +
                             ": the bag has " + describe(topic_types(bag)));
  }
  const std::string reflectors = topic_of_type(bag, path, kReflectorType, topics.reflectors);
  return !scans || shows_reflectors(bag, reflectors, min_reflectors) ? EgomotionSource::kReflectors
                                                                     : EgomotionSource::kScans;
}

CalibrationRecording read(const rosbag::Bag& bag, const std::string& path,
                          const CalibrationTopics& topics, const SegmentRecorderParams& params,
                          const ScanNormalizerParams& scanner) {
  const std::string encoders = topic_of_type(bag, path, kEncoderType, topics.encoders);
  const bool from_scans = params.egomotion == EgomotionSource::kScans;
  const std::string seen = from_scans ? topic_of_type(bag, path, kScanType, topics.scans)
                                      : topic_of_type(bag, path, kReflectorType, topics.reflectors);
  SegmentRecorder recorder(params);
  ScanObservation observation;
  std::size_t readings = 0, scans = 0;
  rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{encoders, seen}));
  for (const rosbag::MessageInstance& instance : view) {
    if (const auto reading = instance.instantiate<TricycleEncoders>()) {
      recorder.add(from_message(*reading));
      ++readings;
    } else if (const auto reflectors = instance.instantiate<ReflectorArray>()) {
      recorder.add(from_message(*reflectors));
      ++scans;
    } else if (const auto scan = instance.instantiate<sensor_msgs::LaserScan>()) {
      if (normalize(as_raw_scan(*scan), scanner, observation.scan).usable()) {
        recorder.add(observation);
      }
      ++scans;
    }
  }
  recorder.finish();
  CalibrationRecording recording;
  recording.segments = recorder.take();
  recording.description = std::to_string(readings) + " encoder readings on " + encoders + ", " +
                          std::to_string(scans) +
                          (from_scans ? " scans on " : " scans with reflectors on ") + seen +
                          "; egomotion from " + name_of(params.egomotion);
  return recording;
}

}  // namespace

EgomotionSource egomotion_in(const std::string& bag, const CalibrationTopics& topics,
                             std::size_t min_reflectors) {
  try {
    return source_in(rosbag::Bag(bag), bag, topics, min_reflectors);
  } catch (const ros::Exception& error) {
    throw std::runtime_error(bag + ": " + error.what());
  }
}

CalibrationRecording read_calibration_drive(const std::string& bag, const CalibrationTopics& topics,
                                            const SegmentRecorderParams& params,
                                            const ScanNormalizerParams& scanner) {
  try {
    return read(rosbag::Bag(bag), bag, topics, params, scanner);
  } catch (const ros::Exception& error) {
    throw std::runtime_error(bag + ": " + error.what());
  }
}

}  // namespace falko_slam
