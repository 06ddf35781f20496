// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace falko_slam {

/// An undirected graph as one row of bits for each vertex.
class BitGraph {
 public:
  explicit BitGraph(std::size_t vertices = 0) { reset(vertices); }

  /// Forgets all edges; keeps its memory.
  void reset(std::size_t vertices) {
    size_ = vertices;
    words_ = (vertices + 63) / 64;
    bits_.assign(size_ * words_, 0);
  }
  /// Two different vertices; adding an edge again changes nothing.
  void add_edge(std::size_t a, std::size_t b) {
    bits_[a * words_ + b / 64] |= std::uint64_t{1} << (b % 64);
    bits_[b * words_ + a / 64] |= std::uint64_t{1} << (a % 64);
  }

  std::size_t size() const { return size_; }
  std::size_t words() const { return words_; }  ///< in a row
  const std::uint64_t* row(std::size_t vertex) const { return bits_.data() + vertex * words_; }
  bool has_edge(std::size_t a, std::size_t b) const { return (row(a)[b / 64] >> (b % 64)) & 1U; }

 private:
  std::size_t size_ = 0;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// How far a clique search goes.
struct CliqueLimits {
  std::size_t larger_than = 0;         ///< smaller cliques, and those of this size, do not count
  std::uint64_t max_nodes = 10000000;  ///< of the search tree
};

struct CliqueResult {
  std::vector<std::size_t> vertices;  ///< ascending; empty if none was larger than asked for
  bool proven = true;                 ///< no larger clique exists; false: the nodes ran out
  std::uint64_t nodes = 0;            ///< visited
};

/// Exact maximum clique by branch and bound on bit rows (\cite sansegundo2011bitset): the vertices
/// in degeneracy order, those that may extend the clique coloured greedily, and of them only those
/// tried whose colour leaves room for a larger clique (\cite tomita2003clique).
///
/// Exponential at worst, hence the limit of nodes; what was found when they run out is a clique
/// still. Not thread-safe; keeps its memory, so that searching allocates nothing in steady state
/// but the answer.
class MaximumClique {
 public:
  CliqueResult search(const BitGraph& graph, const CliqueLimits& limits = {});

 private:
  using Word = std::uint64_t;
  struct Branch {
    std::size_t vertex, color;
  };
  // What a level of the search tree works on.
  struct Level {
    std::vector<Word> candidates;
    std::vector<Branch> branches;
  };

  void relabel_by_degeneracy(const BitGraph& graph);
  void color(Level& level, std::size_t colors_without_gain);
  void expand(std::size_t depth);

  CliqueLimits limits_;
  BitGraph graph_;                  // relabelled
  std::vector<std::size_t> order_;  // old number of each new vertex
  std::vector<std::size_t> degree_;
  std::vector<Level> levels_;
  std::vector<Word> uncolored_;
  std::vector<Word> color_class_;
  std::vector<std::size_t> clique_;
  std::vector<std::size_t> best_;
  std::size_t best_size_ = 0;
  std::uint64_t nodes_ = 0;
};

}  // namespace falko_slam
