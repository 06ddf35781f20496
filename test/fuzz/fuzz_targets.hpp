// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// All fuzz targets, one file each: what takes in bytes that nobody vouches for.
#define FALKO_SLAM_FUZZ_TARGETS(TARGET) \
  TARGET(calibration_file)              \
  TARGET(calibration_session)           \
  TARGET(carmen_log)                    \
  TARGET(encoders)                      \
  TARGET(g2o_file)                      \
  TARGET(grid_map)                      \
  TARGET(imk_file)                      \
  TARGET(joint_states)                  \
  TARGET(keyframe_file)                 \
  TARGET(landmark_map)                  \
  TARGET(localizer)                     \
  TARGET(mrclam_log)                    \
  TARGET(packed_lines)                  \
  TARGET(parameter_file)                \
  TARGET(pose_file)                     \
  TARGET(relations)                     \
  TARGET(scan)                          \
  TARGET(scenario)                      \
  TARGET(slam)                          \
  TARGET(slam_state)                    \
  TARGET(trajectory_file)               \
  TARGET(tricycle_log)

namespace falko_slam {
namespace fuzz {

// fuzz_carmen_log(input) returns whatever the input is. A crash, an exception that the callee does
// not promise, a sanitizer's report, much time or much memory is a finding.
#define FALKO_SLAM_DECLARE(NAME) void fuzz_##NAME(const std::string& input);
FALKO_SLAM_FUZZ_TARGETS(FALKO_SLAM_DECLARE)
#undef FALKO_SLAM_DECLARE

}  // namespace fuzz
}  // namespace falko_slam
