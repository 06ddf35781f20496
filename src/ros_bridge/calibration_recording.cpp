// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/calibration_recording.hpp"

#include <falko_slam/ReflectorArray.h>
#include <falko_slam/TricycleEncoders.h>
#include <ros/exception.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cmath>
#include <stdexcept>

#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/reflector_conversion.hpp"
#include "recording_topics.hpp"

namespace falko_slam {
namespace {

CalibrationRecording read(const rosbag::Bag& bag, const std::string& path,
                          const CalibrationTopics& topics, const SegmentRecorderParams& params) {
  const std::string encoders =
      topic_of_type(bag, path, "falko_slam/TricycleEncoders", topics.encoders);
  const std::string reflectors =
      topic_of_type(bag, path, "falko_slam/ReflectorArray", topics.reflectors);
  SegmentRecorder recorder(params);
  std::size_t readings = 0, scans = 0;
  rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{encoders, reflectors}));
  for (const rosbag::MessageInstance& instance : view) {
    if (const auto reading = instance.instantiate<TricycleEncoders>()) {
      recorder.add(from_message(*reading));
      ++readings;
    } else if (const auto scan = instance.instantiate<ReflectorArray>()) {
      recorder.add(from_message(*scan));
      ++scans;
    }
  }
  recorder.finish();
  CalibrationRecording recording;
  recording.segments = recorder.take();
  recording.description = std::to_string(readings) + " encoder readings on " + encoders + ", " +
                          std::to_string(scans) + " scans with reflectors on " + reflectors;
  return recording;
}

}  // namespace

CalibrationRecording read_calibration_drive(const std::string& bag, const CalibrationTopics& topics,
                                            const SegmentRecorderParams& params) {
  try {
    return read(rosbag::Bag(bag), bag, topics, params);
  } catch (const ros::Exception& error) {
    throw std::runtime_error(bag + ": " + error.what());
  }
}

}  // namespace falko_slam
