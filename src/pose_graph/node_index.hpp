// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "falko_slam/pose_graph/pose_graph.hpp"

namespace falko_slam {

/// Where each node stands in the list of nodes.
class NodeIndex {
 public:
  NodeIndex() = default;
  explicit NodeIndex(const std::vector<GraphNode>& nodes) {
    index_.reserve(nodes.size());
    for (const GraphNode& node : nodes) add(node.id);
  }

  /// Gives it the next number. Throws std::invalid_argument if it has one.
  void add(KeyframeId id) {
    if (!index_.emplace(id, index_.size()).second) {
      throw std::invalid_argument("node " + std::to_string(id.value) + ": is there already");
    }
  }
  /// Throws std::invalid_argument that names the node.
  std::size_t at(KeyframeId id) const {
    const auto found = index_.find(id);
    if (found == index_.end()) {
      throw std::invalid_argument("node " + std::to_string(id.value) + ": is not in the graph");
    }
    return found->second;
  }
  bool has(KeyframeId id) const { return index_.count(id) > 0; }

 private:
  std::unordered_map<KeyframeId, std::size_t> index_;
};

}  // namespace falko_slam
