// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/correspondence_graph.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "compatible_edges.hpp"
#include "falko_slam/common/validation.hpp"
#include "falko_slam/matching/maximum_clique.hpp"

namespace falko_slam {
namespace {

// The circle of headings in windows of 5.6 degrees. Wider ones hold more edges that have nothing
// to do with each other, narrower ones hold an edge more often.
constexpr std::uint32_t kWindowBits = 6;
constexpr std::uint32_t kWindows = 1U << kWindowBits;
constexpr BinaryAngle kWindowExtent = (BinaryAngle{1} << (32 - kWindowBits)) - 1;

using Edges = std::vector<CompatibleEdge>;

std::uint32_t window_of(BinaryAngle heading) { return heading >> (32 - kWindowBits); }

std::size_t edges_of_clique(std::size_t vertices) { return vertices * (vertices - 1) / 2; }

}  // namespace

void validate(const CorrespondenceGraphParams& params) {
  require_in_range("distance_tolerance", params.distance_tolerance, 1e-6, 10.0);
  require_in_range("orientation_gate", params.orientation_gate, 0.0, 1.5);
  require_in_range("residual_noise", params.residual_noise, 0.0, 10.0);
}

// Branch and bound over the heading, with a clique search at each window of headings.
class CorrespondenceGraphMatcher::Search {
 public:
  std::vector<MatchPair> run(const std::vector<MatchPoint>& source,
                             const std::vector<MatchPoint>& target, const PairPredicate& may_match,
                             const CorrespondenceGraphParams& params);

  bool proven() const { return proven_; }
  std::uint64_t nodes() const { return nodes_; }

 private:
  void fill_windows();
  void explore(const HeadingArc& window, Edges& edges);
  Edges edges_within(const HeadingArc& window, const Edges& edges) const;
  void count_degrees(const Edges& edges);
  void peel(Edges& edges, std::size_t min_degree);
  Edges densest_core(const Edges& edges);
  std::vector<std::uint32_t> larger_clique(const Edges& edges);
  std::optional<BinaryAngle> conflict(const HeadingArc& window,
                                      const std::vector<std::uint32_t>& clique) const;

  CompatibleEdges compatible_;
  std::array<Edges, kWindows> windows_;
  std::vector<std::uint32_t> degree_;
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

std::vector<MatchPair> CorrespondenceGraphMatcher::Search::run(
    const std::vector<MatchPoint>& source, const std::vector<MatchPoint>& target,
    const PairPredicate& may_match, const CorrespondenceGraphParams& params) {
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
    explore({window << (32 - kWindowBits), kWindowExtent}, windows_[window]);
  }
  std::vector<MatchPair> pairs;
  for (const std::uint32_t vertex : best_) pairs.push_back(compatible_.pair(vertex));
  return pairs;
}

void CorrespondenceGraphMatcher::Search::fill_windows() {
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
void CorrespondenceGraphMatcher::Search::explore(const HeadingArc& window, Edges& edges) {
  for (;;) {
    count_degrees(edges);
    peel(edges, best_size_);
    if (edges.empty()) return;
    if (nodes_ == max_nodes_) {
      proven_ = false;
      return;
    }
    ++nodes_;
    std::vector<std::uint32_t> clique = larger_clique(densest_core(edges));
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

Edges CorrespondenceGraphMatcher::Search::edges_within(const HeadingArc& window,
                                                       const Edges& edges) const {
  Edges within;
  for (const CompatibleEdge& edge : edges) {
    const auto arc = compatible_.headings(edge);
    if (arc && intersection(window, *arc)) within.push_back(edge);
  }
  return within;
}

void CorrespondenceGraphMatcher::Search::count_degrees(const Edges& edges) {
  degree_.assign(compatible_.vertices(), 0);
  for (const CompatibleEdge& edge : edges) {
    ++degree_[edge.a];
    ++degree_[edge.b];
  }
}

// Leaves the edges between vertices that keep at least `min_degree` of them: no others belong to a
// clique of min_degree + 1. The degrees must be those of the edges, and stay so.
void CorrespondenceGraphMatcher::Search::peel(Edges& edges, std::size_t min_degree) {
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

// Where a large clique is likely: what stays longest as the least degree asked for rises. The
// degrees must be those of the edges.
Edges CorrespondenceGraphMatcher::Search::densest_core(const Edges& edges) {
  Edges core;
  Edges denser = edges;
  for (std::size_t degree = best_size_ + 1; !denser.empty(); ++degree) {
    core = denser;
    peel(denser, degree);
  }
  return core;
}

// The vertices of a maximum clique, ascending; none if it is not larger than the best match.
std::vector<std::uint32_t> CorrespondenceGraphMatcher::Search::larger_clique(const Edges& edges) {
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
std::optional<BinaryAngle> CorrespondenceGraphMatcher::Search::conflict(
    const HeadingArc& window, const std::vector<std::uint32_t>& clique) const {
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

CorrespondenceGraphMatcher::CorrespondenceGraphMatcher(const CorrespondenceGraphParams& params)
    : params_(params), search_(std::make_unique<Search>()) {
  validate(params_);
}
CorrespondenceGraphMatcher::~CorrespondenceGraphMatcher() = default;
CorrespondenceGraphMatcher::CorrespondenceGraphMatcher(CorrespondenceGraphMatcher&&) noexcept =
    default;
CorrespondenceGraphMatcher& CorrespondenceGraphMatcher::operator=(
    CorrespondenceGraphMatcher&&) noexcept = default;

MatchResult CorrespondenceGraphMatcher::match(const std::vector<MatchPoint>& source,
                                              const std::vector<MatchPoint>& target,
                                              const PairPredicate& may_match) {
  std::vector<MatchPair> pairs = search_->run(source, target, may_match, params_);
  MatchResult result = match_of(std::move(pairs), source, target, params_.residual_noise);
  result.proven = search_->proven();
  result.search_nodes = search_->nodes();
  return result;
}

}  // namespace falko_slam
