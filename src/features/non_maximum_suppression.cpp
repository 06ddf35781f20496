// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "non_maximum_suppression.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <tuple>

namespace falko_slam {
namespace {

// Below this squared roughness corners count the same.
constexpr double kPerfect = 1e-6;

// Floats that are not negative have the order of their bits.
std::uint64_t sort_key(float rank, std::size_t index) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &rank, sizeof bits);
  return (static_cast<std::uint64_t>(bits) << 32) | static_cast<std::uint32_t>(index);
}

std::size_t index(std::uint64_t sort_key) { return static_cast<std::uint32_t>(sort_key); }

bool breaks_tie(const CornerCandidate& a, const CornerCandidate& b) {
  return std::tie(a.range, a.slope, a.beam) < std::tie(b.range, b.slope, b.beam);
}

}  // namespace

void NonMaximumSuppression::sort_best_first(const std::vector<CornerCandidate>& candidates) {
  order_.clear();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    order_.push_back(sort_key(candidates[i].rank, i));
  }
  std::sort(order_.begin(), order_.end());
  const auto same_rank = [](std::uint64_t a, std::uint64_t b) { return a >> 32 == b >> 32; };
  auto begin = std::adjacent_find(order_.begin(), order_.end(), same_rank);
  while (begin != order_.end()) {
    const auto end = std::find_if(begin, order_.end(),
                                  [&](std::uint64_t key) { return !same_rank(key, *begin); });
    std::sort(begin, end, [&](std::uint64_t a, std::uint64_t b) {
      return breaks_tie(candidates[index(a)], candidates[index(b)]);
    });
    begin = std::adjacent_find(end, order_.end(), same_rank);
  }
}

const std::vector<KeptCorner>& NonMaximumSuppression::operator()(
    const std::vector<CornerCandidate>& candidates, double suppression_radius,
    double merge_radius) {
  sort_best_first(candidates);
  peaks_.clear();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double suppression_square = suppression_radius * suppression_radius;
  const double merge_square = merge_radius * merge_radius;
  for (const std::uint64_t key : order_) {
    const CornerCandidate& candidate = candidates[index(key)];
    const double x = candidate.position.x();
    const double y = candidate.position.y();
    const double weight = 1.0 / (candidate.roughness_square + kPerfect);
    double nearest = infinity;
    for (Peak& peak : peaks_) {
      const double square = (peak.x - x) * (peak.x - x) + (peak.y - y) * (peak.y - y);
      nearest = std::min(nearest, square);
      if (square > merge_square) continue;
      peak.weight += weight;
      peak.sum_x += weight * x;
      peak.sum_y += weight * y;
    }
    if (nearest <= suppression_square) continue;
    peaks_.push_back({x, y, weight, weight * x, weight * y, index(key)});
  }
  std::sort(peaks_.begin(), peaks_.end(),
            [](const Peak& a, const Peak& b) { return a.index < b.index; });
  kept_.clear();
  for (const Peak& peak : peaks_) {
    kept_.push_back({peak.index, {peak.sum_x / peak.weight, peak.sum_y / peak.weight}});
  }
  return kept_;
}

}  // namespace falko_slam
