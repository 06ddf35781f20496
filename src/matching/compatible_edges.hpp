// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "falko_slam/matching/correspondence_graph.hpp"
#include "heading_arc.hpp"
#include "segments.hpp"

namespace falko_slam {

/// Two compatible vertices of the correspondence graph. The pair (i_s, i_t) is vertex
/// i_s * (number of target points) + i_t.
struct CompatibleEdge {
  std::uint32_t a, b;
};

/// The edges of a correspondence graph, and the headings that each of them allows.
class CompatibleEdges {
 public:
  void prepare(const std::vector<MatchPoint>& source, const std::vector<MatchPoint>& target,
               const PairPredicate& may_match, const CorrespondenceGraphParams& params);

  std::size_t vertices() const { return vertices_.size(); }
  MatchPair pair(std::size_t vertex) const { return {vertex / targets_, vertex % targets_}; }

  /// Calls visit(edge, headings) for every edge that allows a heading, the shortest segments first.
  template <class Visit>
  void for_each(Visit visit) const {
    for_each_equal_length(source_.segments, target_.segments, tolerance_,
                          [&](const Segment& s, const Segment& t) {
                            visit_if_allowed({s.first, t.first}, {s.second, t.second}, visit);
                            visit_if_allowed({s.first, t.second}, {s.second, t.first}, visit);
                          });
  }

  /// The headings that an edge allows; empty if none.
  std::optional<HeadingArc> headings(const CompatibleEdge& edge) const {
    return headings(pair(edge.a), pair(edge.b));
  }

 private:
  // A segment's direction and how far it may be off: kOpen if it has none.
  struct Span {
    BinaryAngle direction, slack;
  };
  static constexpr BinaryAngle kOpen = ~BinaryAngle{0};
  // The segments of one set, and their spans as a matrix over both ends.
  struct Side {
    std::vector<Segment> segments;
    std::vector<Span> spans;
    std::vector<Eigen::Vector2d> positions;
    std::size_t points = 0;

    // Does nothing if the last set had the same positions, for one set is often matched with
    // several. The tolerance must always be the same.
    void prepare(const std::vector<MatchPoint>& set, double tolerance);
    const Span& span(std::size_t from, std::size_t to) const { return spans[from * points + to]; }
  };
  struct Vertex {
    HeadingArc headings;
    bool allowed;
  };

  std::uint32_t vertex(const MatchPair& pair) const {
    return static_cast<std::uint32_t>(pair.source * targets_ + pair.target);
  }
  template <class Visit>
  void visit_if_allowed(const MatchPair& a, const MatchPair& b, Visit visit) const {
    const CompatibleEdge edge{vertex(a), vertex(b)};
    if (!vertices_[edge.a].allowed || !vertices_[edge.b].allowed) return;
    if (const auto arc = headings(a, b)) visit(edge, *arc);
  }
  std::optional<HeadingArc> headings(const MatchPair& a, const MatchPair& b) const {
    const Span& s = source_.span(a.source, b.source);
    const Span& t = target_.span(a.target, b.target);
    const BinaryAngle slack = std::max(s.slack, t.slack);
    HeadingArc arc;
    if (slack != kOpen) arc = arc_around(t.direction - s.direction, slack);
    const auto first = intersection(arc, vertices_[vertex(a)].headings);
    return first ? intersection(*first, vertices_[vertex(b)].headings) : std::nullopt;
  }

  double tolerance_ = 0.0;
  std::size_t targets_ = 0;
  Side source_, target_;
  std::vector<Vertex> vertices_;
};

}  // namespace falko_slam
