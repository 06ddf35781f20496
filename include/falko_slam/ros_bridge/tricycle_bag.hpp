// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {

struct TricycleBagParams {
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  std::string laser_frame = "laser";
  std::string tracker_frame = "laser_start";  ///< where the laser stood when the tracker began
  bool replace = false;                       ///< an existing file
};

/// Converts the log of a tricycle (see TricycleLogReader) to a ROS bag and returns what was read
/// and written, in words, with the header's nominal values.
///
/// Topics: `encoders` (the counters as recorded), `joint_states` (the same as angles, by the gains
/// of the header; the drive joint is the encoder's shaft), `odom` and `tf` (the vehicle's own
/// odometry with nominal values: pose of base_frame in odom_frame, no velocity), `tf_static`
/// (base_frame -> laser_frame by the header, latched) and `ground_truth`.
///
/// `ground_truth` is the pose of the LASER, not of the base, in tracker_frame: the laser's own pose
/// at its start. No transform leads there.
///
/// Messages keep the order of the log and their own stamps, also where these run backward; the
/// times at which the bag plays them never do. Throws std::runtime_error that names the file.
std::string convert_tricycle_log(const std::string& log, const std::string& bag,
                                 const TricycleBagParams& params);

}  // namespace falko_slam
