// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// The parsers of what stands behind the first word of a line. Throw std::runtime_error that says
/// what is wrong with it.
GraphNode parse_g2o_vertex(const std::string& text);
GraphConstraint parse_g2o_edge(const std::string& text);
GraphConstraint parse_toro_edge(const std::string& text);
std::vector<KeyframeId> parse_g2o_fix(const std::string& text);

}  // namespace falko_slam
