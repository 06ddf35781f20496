// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "graph_core.hpp"

#include <algorithm>

namespace falko_slam {

void GraphCore::peel(CompatibleEdgeList& edges, std::size_t min_degree, std::size_t vertices) {
  degree_.assign(vertices, 0);
  for (const CompatibleEdge& edge : edges) {
    ++degree_[edge.a];
    ++degree_[edge.b];
  }
  drop_below(edges, min_degree);
}

CompatibleEdgeList GraphCore::densest(const CompatibleEdgeList& edges, std::size_t min_degree) {
  CompatibleEdgeList core;
  CompatibleEdgeList denser = edges;
  for (std::size_t degree = min_degree; !denser.empty(); ++degree) {
    core = denser;
    drop_below(denser, degree);
  }
  return core;
}

// The degrees are those of the edges, and stay so.
void GraphCore::drop_below(CompatibleEdgeList& edges, std::size_t min_degree) {
  const auto falls = [&](const CompatibleEdge& edge) {
    if (degree_[edge.a] >= min_degree && degree_[edge.b] >= min_degree) return false;
    --degree_[edge.a];
    --degree_[edge.b];
    return true;
  };
  std::size_t before = 0;
  do {
    before = edges.size();
    edges.erase(std::remove_if(edges.begin(), edges.end(), falls), edges.end());
  } while (edges.size() < before);
}

}  // namespace falko_slam
