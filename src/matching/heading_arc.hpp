// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {

/// A heading in 2^-32 turns: sums and differences wrap by themselves, and are exact.
using BinaryAngle = std::uint32_t;

constexpr double kBinaryTurn = 4294967296.0;

inline BinaryAngle binary_angle(double radians) {
  const double turns = wrap_angle(radians) / kTwoPi;  // [-0.5, 0.5)
  return static_cast<BinaryAngle>(static_cast<std::int64_t>(std::floor(turns * kBinaryTurn)));
}

/// The headings from `begin` on, `extent` steps counter-clockwise, both ends included.
struct HeadingArc {
  BinaryAngle begin = 0;
  BinaryAngle extent = ~BinaryAngle{0};

  bool full() const { return extent == ~BinaryAngle{0}; }
};

/// All headings that differ from `center` by at most `half_width`, less than half a turn.
inline HeadingArc arc_around(BinaryAngle center, BinaryAngle half_width) {
  return {center - half_width, 2 * half_width};
}

/// Of arcs that are full or less than half a turn; empty if they have no heading in common.
inline std::optional<HeadingArc> intersection(const HeadingArc& a, const HeadingArc& b) {
  if (a.full()) return b;
  if (b.full()) return a;
  // Two arcs of less than half a turn overlap in one piece, if at all.
  const std::int64_t offset = static_cast<std::int32_t>(b.begin - a.begin);
  const std::int64_t low = std::max<std::int64_t>(0, offset);
  const std::int64_t high = std::min<std::int64_t>(a.extent, offset + b.extent);
  if (low > high) return std::nullopt;
  return HeadingArc{a.begin + static_cast<BinaryAngle>(low), static_cast<BinaryAngle>(high - low)};
}

}  // namespace falko_slam
