// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "bright_run.hpp"

#include <algorithm>
#include <cmath>

namespace falko_slam {

BrightProfile profile_of(const BrightBeam* first, std::size_t count) {
  BrightProfile profile;
  double with_range = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const BrightBeam& beam = first[i];
    profile.peak = std::max(profile.peak, beam.excess);
    profile.sum += beam.excess;
    profile.middle += beam.excess * static_cast<double>(i);
    if (std::isnan(beam.range)) continue;
    with_range += beam.excess;
    profile.range += beam.excess * beam.range;
  }
  profile.middle /= profile.sum;
  profile.range /= with_range;
  // Between beams the excess is taken as straight, beyond the ends it is none.
  const double half = 0.5 * profile.peak;
  const auto excess = [&](std::size_t i) { return i < count ? first[i].excess : 0.0; };
  std::size_t begin = 0, end = count - 1;
  while (first[begin].excess < half) ++begin;
  while (first[end].excess < half) --end;
  const double before = begin > 0 ? excess(begin - 1) : 0.0;
  const double after = excess(end + 1);
  profile.half_begin =
      static_cast<double>(begin) - (first[begin].excess - half) / (first[begin].excess - before);
  profile.half_end =
      static_cast<double>(end) + (first[end].excess - half) / (first[end].excess - after);
  return profile;
}

std::size_t valley_of(const BrightBeam* first, std::size_t count, double depth) {
  std::size_t valley = count;
  double deepest = depth;
  double left = 0.0;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    left = std::max(left, first[i - 1].excess);
    double right = 0.0;
    for (std::size_t j = i + 1; j < count; ++j) right = std::max(right, first[j].excess);
    const double lower = std::min(left, right);
    if (lower > deepest * first[i].excess) {
      deepest = lower / std::max(first[i].excess, 1e-9 * lower);
      valley = i;
    }
  }
  return valley;
}

}  // namespace falko_slam
