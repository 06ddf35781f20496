// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "segments.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace falko_slam {

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
      segments.push_back({length, std::atan2(span.y(), span.x()), i, j});
    }
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
    return std::tie(a.length, a.first, a.second) < std::tie(b.length, b.first, b.second);
  });
}

}  // namespace falko_slam
