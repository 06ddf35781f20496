// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/pose_file.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_pose_file(const std::string& input) {
  const std::string path = input_file("pose.yaml", input);
  read_or_refuse(path, [&] {
    const SavedPose pose = read_saved_pose(path);
    objection_to(pose, pose.map, pose.stamp, Duration(1));
    write_saved_pose(path, pose);
    require(read_saved_pose(path).map == pose.map, "a pose that was read can be written");
  });
}
