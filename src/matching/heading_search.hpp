// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "compatible_edges.hpp"
#include "falko_slam/matching/maximum_clique.hpp"
#include "graph_core.hpp"

namespace falko_slam {

/// The largest match of a correspondence graph: branch and bound over the heading, with a clique
/// search in each window of headings.
///
/// A match has a heading that all its edges allow, so it is a clique of the edges that allow some
/// heading of the window which holds it. Windows are looked at by their number of edges, the
/// fullest first, and only as long as a clique larger than the best one may be in them. If the
/// largest clique of a window has no common heading, two of its edges disagree; the window is cut
/// between them, and both parts are searched.
class HeadingSearch {
 public:
  /// The pairs of the largest match; none if it has fewer than two.
  std::vector<MatchPair> run(const std::vector<MatchPoint>& source,
                             const std::vector<MatchPoint>& target, const PairPredicate& may_match,
                             const CorrespondenceGraphParams& params);

  bool proven() const { return proven_; }         ///< of the last run
  std::uint64_t nodes() const { return nodes_; }  ///< windows and nodes of clique searches

 private:
  using Edges = CompatibleEdgeList;
  // The circle in windows of 5.6 degrees. Wider ones hold more edges that have nothing to do with
  // each other, narrower ones hold an edge more often.
  static constexpr std::uint32_t kWindowBits = 6;
  static constexpr std::uint32_t kWindows = 1U << kWindowBits;

  static std::uint32_t window_of(BinaryAngle heading) { return heading >> (32 - kWindowBits); }

  void fill_windows();
  void explore(const HeadingArc& window, Edges& edges);
  Edges edges_within(const HeadingArc& window, const Edges& edges) const;
  std::vector<std::uint32_t> larger_clique(const Edges& edges);
  std::optional<BinaryAngle> conflict(const HeadingArc& window,
                                      const std::vector<std::uint32_t>& clique) const;

  CompatibleEdges compatible_;
  std::array<Edges, kWindows> windows_;
  GraphCore core_;
  std::vector<std::uint32_t> label_;
  std::vector<std::uint32_t> labelled_;
  BitGraph graph_;
  MaximumClique maximum_clique_;
  std::vector<std::uint32_t> best_;
  std::size_t best_size_ = 0;
  std::uint64_t nodes_ = 0;
  std::uint64_t max_nodes_ = 0;
  bool proven_ = true;
};

}  // namespace falko_slam
