// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// A planar graph as g2o writes it, read from text that may be packed (.gz, .bz2):
///
///     VERTEX_SE2 id x y theta                                       [m, m, rad]
///     EDGE_SE2   from to x y theta  I11 I12 I13 I22 I23 I33         upper triangle of information
///     FIX        id ...
///     VERTEX2    id x y theta                                       as TORO writes it
///     EDGE2      from to x y theta  I11 I12 I22 I33 I13 I23         mind the order
///
/// An edge of nodes whose ids follow each other is odometry, any other a closure.
struct G2oFile {
  PoseGraph graph;
  bool has_poses = true;  ///< false: no vertex stood there, the nodes are those of the edges, at 0
  std::map<std::string, std::size_t> unknown_tags;  ///< how many lines began so, and were left out
};

/// Throws std::runtime_error that names file, line and what is wrong with it.
G2oFile read_g2o(const std::string& path);

/// Writes a whole file or none, packed where the name ends in .gz or .bz2, with the digits that
/// bring back the same bits. Throws std::runtime_error that names the file.
void write_g2o(const std::string& path, const PoseGraph& graph);

}  // namespace falko_slam
