// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/g2o_file.hpp"
#include "falko_slam/pose_graph/optimizer.hpp"
#include "fuzz/fuzz_targets.hpp"
#include "fuzz/input_file.hpp"

void falko_slam::fuzz::fuzz_g2o_file(const std::string& input) {
  const std::string path = input_file("graph.g2o", input);
  read_or_refuse(path, [&] {
    const G2oFile file = read_g2o(path);
    write_g2o(path, file.graph);
    const PoseGraph again = read_g2o(path).graph;
    require(again.nodes.size() == file.graph.nodes.size() &&
                again.constraints.size() == file.graph.constraints.size(),
            "what was read is written as the same graph");
  });
}
