// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "compatible_edges.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {
namespace {

constexpr BinaryAngle kHalfTurn = BinaryAngle{1} << 31;
constexpr BinaryAngle kQuarterTurn = BinaryAngle{1} << 30;

}  // namespace

void CompatibleEdges::Side::prepare(const std::vector<MatchPoint>& set, double tolerance) {
  if (std::equal(set.begin(), set.end(), positions.begin(), positions.end(),
                 [](const MatchPoint& a, const Eigen::Vector2d& b) { return a.position == b; })) {
    return;
  }
  positions.clear();
  for (const MatchPoint& point : set) positions.push_back(point.position);
  points = set.size();
  find_segments(set, 0.0, segments);
  spans.resize(points * points);
  for (const Segment& segment : segments) {
    Span forward{binary_angle(segment.direction), kOpen};
    if (segment.length > tolerance) {
      forward.slack =
          std::min(binary_angle(std::asin(tolerance / segment.length)), kQuarterTurn - 1);
    }
    spans[segment.first * points + segment.second] = forward;
    spans[segment.second * points + segment.first] = {forward.direction + kHalfTurn, forward.slack};
  }
}

void CompatibleEdges::prepare(const std::vector<MatchPoint>& source,
                              const std::vector<MatchPoint>& target, const PairPredicate& may_match,
                              const CorrespondenceGraphParams& params) {
  tolerance_ = params.distance_tolerance;
  targets_ = target.size();
  source_.prepare(source, tolerance_);
  target_.prepare(target, tolerance_);
  const BinaryAngle gate = binary_angle(params.orientation_gate);
  vertices_.clear();
  for (std::size_t s = 0; s < source.size(); ++s) {
    for (std::size_t t = 0; t < target.size(); ++t) {
      Vertex vertex{{}, !may_match || may_match(s, t)};
      if (source[s].has_orientation() && target[t].has_orientation()) {
        vertex.headings = arc_around(
            binary_angle(target[t].orientation) - binary_angle(source[s].orientation), gate);
      }
      vertices_.push_back(vertex);
    }
  }
}

}  // namespace falko_slam
