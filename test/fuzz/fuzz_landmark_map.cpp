// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/localization/landmark_map.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_landmark_map(const std::string& input) {
  const std::string path = input_file("landmarks.yaml", input);
  read_or_refuse(path, [&] {
    const LandmarkMap map = read_landmark_map(path);
    write_landmark_map(path, map);
    require(read_landmark_map(path).landmarks.size() == map.landmarks.size(),
            "a map that was read is written as the same map");
  });
}
