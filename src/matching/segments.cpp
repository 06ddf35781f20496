// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segments.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

std::uint32_t turn_of(const MatchPoint& point, double direction) {
  if (!point.has_orientation()) return 0;
  const double turns = (point.orientation - direction) / kTwoPi;
  return static_cast<std::uint32_t>(
      static_cast<std::int64_t>((turns - std::floor(turns)) * 4294967296.0));
}

bool before(const Segment& a, const Segment& b) {
  return std::tie(a.length, a.first, a.second) < std::tie(b.length, b.first, b.second);
}

// First into as many drawers as there are segments, by length, then the few that are out of order.
void sort_by_length(std::vector<Segment>& segments) {
  if (segments.size() < 2) return;
  double longest = 0.0;
  for (const Segment& segment : segments) longest = std::max(longest, segment.length);
  const double scale = static_cast<double>(segments.size() - 1) / longest;
  // Points at one place, or farther apart than numbers go.
  if (!(scale > 0.0 && std::isfinite(scale))) {
    std::sort(segments.begin(), segments.end(), before);
    return;
  }
  const auto drawer_of = [&](const Segment& segment) {
    return static_cast<std::size_t>(segment.length * scale);
  };
  std::vector<std::uint32_t> ends(segments.size() + 1, 0);
  for (const Segment& segment : segments) ++ends[drawer_of(segment) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Segment> sorted(segments.size());
  for (const Segment& segment : segments) sorted[ends[drawer_of(segment)]++] = segment;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    for (std::size_t j = i; j > 0 && before(sorted[j], sorted[j - 1]); --j) {
      std::swap(sorted[j], sorted[j - 1]);
    }
  }
  segments.swap(sorted);
}

}  // namespace

void find_segments(const std::vector<MatchPoint>& points, double min_length,
                   std::vector<Segment>& segments) {
  segments.clear();
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!points[i].usable()) continue;
    for (std::uint32_t j = i + 1; j < points.size(); ++j) {
      if (!points[j].usable()) continue;
      const Eigen::Vector2d span = points[j].position - points[i].position;
      const double length = span.norm();
      if (length < min_length) continue;
      const double direction = std::atan2(span.y(), span.x());
      segments.push_back(
          {length, direction, i, j, turn_of(points[i], direction), turn_of(points[j], direction)});
    }
  }
  sort_by_length(segments);
}

}  // namespace falko_slam
