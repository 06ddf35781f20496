// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compatible_edges.hpp"

namespace falko_slam {

using CompatibleEdgeList = std::vector<CompatibleEdge>;

/// Finds where cliques can be by the number of neighbours alone. Keeps its memory.
class GraphCore {
 public:
  /// Leaves the edges between vertices that keep at least `min_degree` of them: no others belong to
  /// a clique of min_degree + 1. Vertex numbers are below `vertices`.
  void peel(CompatibleEdgeList& edges, std::size_t min_degree, std::size_t vertices);

  /// Where a large clique is likely: what stays longest as the degree asked for rises from
  /// `min_degree`. For edges that have just been peeled; they may be peeled again after.
  CompatibleEdgeList densest(const CompatibleEdgeList& edges, std::size_t min_degree);

 private:
  void drop_below(CompatibleEdgeList& edges, std::size_t min_degree);

  std::vector<std::uint32_t> degree_;
};

}  // namespace falko_slam
