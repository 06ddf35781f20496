// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace falko_slam {
namespace test {

// Lines of the log of a tricycle.

/// A steering gain of 0.1, 2e-4 m per tick, a wheelbase of 1.4 m; the laser 1.5 m ahead, turned by
/// a quarter to the left.
inline std::string tricycle_header() {
  return "#kinematic_model: traction_drive_wheel\n"
         "#parameters: [ Ksteer Ktraction axis_length steer_offset ]\n"
         "#parameter_values: 0.1 1.0 1.4 0.02 \n"
         "#joints_max_enc: [ steering traction_wheel ]\n"
         "#joints_max_enc_values: 8192 5000 \n"
         "#laser wrt base_link \n"
         "#\ttranslation:\t[ 1.5, 0.25, 0 ],\n"
         "#\trotation:\t [ 0, 0, 0.7071067811865476, 0.7071067811865476 ]\n";
}

inline std::string tricycle_line(const std::string& seconds, const std::string& ticks,
                                 const std::string& model_pose, const std::string& tracker_pose) {
  return "time: " + seconds + " ticks: " + ticks + " model_pose: " + model_pose +
         " tracker_pose: " + tracker_pose + "\n";
}

/// Over the end of the drive counter, and past the steering's zero.
inline std::string small_tricycle_log() {
  return tricycle_header() +
         tricycle_line("1668091584.821040869", "290 4294967290", "0 0 0", "1e-05 -0.5 0.25") +
         tricycle_line("1668091584.861040869", "8190 4", " 0.002 -1e-08  0.1", "0.5 0.5 0.5") +
         tricycle_line("1668091584.901040869", "8000 2", "0.001 0 -3", "0.75 1 3");
}

}  // namespace test
}  // namespace falko_slam
