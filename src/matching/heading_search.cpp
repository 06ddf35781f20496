// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "heading_search.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace falko_slam {
namespace {

std::size_t edges_of_clique(std::size_t vertices) { return vertices * (vertices - 1) / 2; }

}  // namespace

std::vector<MatchPair> HeadingSearch::run(const std::vector<MatchPoint>& source,
                                          const std::vector<MatchPoint>& target,
                                          const PairPredicate& may_match,
                                          const CorrespondenceGraphParams& params) {
  best_.clear();
  best_size_ = 1;  // one pair is no match
  nodes_ = 0;
  max_nodes_ = params.max_nodes;
  proven_ = true;
  compatible_.prepare(source, target, may_match, params);
  fill_windows();

  std::array<std::uint32_t, kWindows> order{};
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return windows_[a].size() > windows_[b].size();
  });
  const std::size_t most = std::min(source.size(), target.size());
  for (const std::uint32_t window : order) {
    if (best_size_ >= most || windows_[window].size() < edges_of_clique(best_size_ + 1)) break;
    const HeadingArc headings{window << (32 - kWindowBits), (1U << (32 - kWindowBits)) - 1};
    explore(headings, windows_[window]);
  }
  std::vector<MatchPair> pairs;
  for (const std::uint32_t vertex : best_) pairs.push_back(compatible_.pair(vertex));
  return pairs;
}

void HeadingSearch::fill_windows() {
  for (Edges& window : windows_) window.clear();
  compatible_.for_each([&](const CompatibleEdge& edge, const HeadingArc& arc) {
    std::uint32_t window = window_of(arc.begin);
    const std::uint32_t last =
        arc.full() ? (window - 1) % kWindows : window_of(arc.begin + arc.extent);
    for (; window != last; window = (window + 1) % kWindows) windows_[window].push_back(edge);
    windows_[last].push_back(edge);
  });
}

// Finds the largest clique with a common heading in the window, if it is larger than the best one.
// A clique without one splits the window between two of its edges: neither half holds both.
void HeadingSearch::explore(const HeadingArc& window, Edges& edges) {
  for (;;) {
    core_.peel(edges, best_size_, compatible_.vertices());
    if (edges.empty()) return;
    if (nodes_ == max_nodes_) {
      proven_ = false;
      return;
    }
    ++nodes_;
    std::vector<std::uint32_t> clique = larger_clique(core_.densest(edges, best_size_ + 1));
    if (clique.empty()) clique = larger_clique(edges);
    if (clique.empty()) return;
    if (const auto offset = conflict(window, clique)) {
      const HeadingArc left{window.begin, *offset};
      const HeadingArc right{window.begin + *offset + 1, window.extent - *offset - 1};
      for (const HeadingArc& half : {left, right}) {
        Edges within = edges_within(half, edges);
        explore(half, within);
      }
      return;
    }
    best_size_ = clique.size();
    best_ = std::move(clique);
  }
}

HeadingSearch::Edges HeadingSearch::edges_within(const HeadingArc& window,
                                                 const Edges& edges) const {
  Edges within;
  for (const CompatibleEdge& edge : edges) {
    const auto arc = compatible_.headings(edge);
    if (arc && intersection(window, *arc)) within.push_back(edge);
  }
  return within;
}

// The vertices of a maximum clique, ascending; none if it is not larger than the best match.
std::vector<std::uint32_t> HeadingSearch::larger_clique(const Edges& edges) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  label_.assign(compatible_.vertices(), kNone);
  labelled_.clear();
  const auto label = [&](std::uint32_t vertex) {
    if (label_[vertex] == kNone) {
      label_[vertex] = static_cast<std::uint32_t>(labelled_.size());
      labelled_.push_back(vertex);
    }
  };
  for (const CompatibleEdge& edge : edges) {
    label(edge.a);
    label(edge.b);
  }
  graph_.reset(labelled_.size());
  for (const CompatibleEdge& edge : edges) graph_.add_edge(label_[edge.a], label_[edge.b]);
  const CliqueResult result = maximum_clique_.search(graph_, {best_size_, max_nodes_ - nodes_});
  nodes_ += result.nodes;
  proven_ = proven_ && result.proven;
  std::vector<std::uint32_t> clique;
  for (const std::size_t vertex : result.vertices) clique.push_back(labelled_[vertex]);
  std::sort(clique.begin(), clique.end());
  return clique;
}

// Empty if all edges of the clique have a heading of the window in common; else an offset in the
// window: one edge allows only headings up to it, another only ones beyond.
std::optional<BinaryAngle> HeadingSearch::conflict(const HeadingArc& window,
                                                   const std::vector<std::uint32_t>& clique) const {
  BinaryAngle low = 0;
  BinaryAngle high = window.extent;
  for (std::size_t i = 0; i < clique.size(); ++i) {
    for (std::size_t j = i + 1; j < clique.size(); ++j) {
      const auto arc = compatible_.headings({clique[i], clique[j]});
      const HeadingArc shared = *intersection(window, *arc);
      low = std::max(low, shared.begin - window.begin);
      high = std::min(high, shared.begin - window.begin + shared.extent);
    }
  }
  if (low <= high) return std::nullopt;
  return high + (low - 1 - high) / 2;
}

}  // namespace falko_slam
