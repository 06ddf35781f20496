// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/tricycle_bag.hpp"

#include <sstream>
#include <stdexcept>

#include "falko_slam/ros_bridge/bag_file.hpp"
#include "falko_slam/ros_bridge/encoder_conversion.hpp"
#include "falko_slam/ros_bridge/pose_conversion.hpp"
#include "falko_slam/ros_bridge/topics.hpp"
#include "falko_slam/vehicle/tricycle_log.hpp"

namespace falko_slam {
namespace {

class TricycleBagWriter {
 public:
  TricycleBagWriter(BagFile& bag, const TricycleBagParams& params, const TricycleLogHeader& header)
      : bag_(bag),
        params_(params),
        base_T_laser_(header.base_T_laser),
        joints_({encoder_params_of(header), header.traction_ticks_per_turn}) {}

  void write(const TricycleRecord& record) {
    const Time stamp = record.encoders.stamp;
    if (!mount_written_) write_mount(stamp);
    bag_.write(topics::kTf, stamp,
               to_transform(record.odom_T_base, stamp, params_.odom_frame, params_.base_frame));
    bag_.write(topics::kOdometry, stamp,
               odometry_message(record.odom_T_base, stamp, params_.odom_frame, params_.base_frame));
    bag_.write(topics::kGroundTruth, stamp,
               stamped_pose(record.start_T_laser, stamp, params_.tracker_frame));
    bag_.write(topics::kJointStates, stamp, joints_.next(record.encoders));
    bag_.write(topics::kEncoders, stamp, to_message(record.encoders, params_.base_frame));
  }

 private:
  void write_mount(Time stamp) {
    bag_.write_latched(topics::kTfStatic, stamp,
                       to_transform(base_T_laser_, stamp, params_.base_frame, params_.laser_frame));
    mount_written_ = true;
  }

  BagFile& bag_;
  const TricycleBagParams& params_;
  Pose2 base_T_laser_;
  JointStateSource joints_;
  bool mount_written_ = false;
};

std::string describe(const TricycleLogHeader& header) {
  std::ostringstream text;
  text << "nominal values: wheelbase " << header.axis_length << " m, " << header.traction_gain
       << " m per " << header.traction_ticks_per_turn << " drive ticks, steering gain "
       << header.steer_gain << " at " << header.steer_ticks_per_turn
       << " ticks a turn, steer offset " << header.steer_offset << " rad, laser at "
       << header.base_T_laser;
  return text.str();
}

}  // namespace

std::string convert_tricycle_log(const std::string& log, const std::string& bag,
                                 const TricycleBagParams& params) {
  TricycleLogReader reader(log);
  BagFile file(bag, params.replace);
  try {
    TricycleBagWriter writer(file, params, reader.header());
    while (const auto record = reader.next()) writer.write(*record);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(log + ": its header: " + error.what());
  }
  const std::string done = describe(reader.report());
  if (reader.report().records == 0) {
    throw std::runtime_error(log + ": nothing to convert in " + done);
  }
  file.finish();
  return done + file.describe_moved_times() + "\n" + describe(reader.header());
}

}  // namespace falko_slam
