// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_trace.hpp"

#include <algorithm>
#include <cmath>

#include "falko_slam/geometry/angles.hpp"

namespace falko_slam {
namespace {

// Points that are seen in directions farther apart than this are not neighbours, however near
// [rad].
constexpr double kWidestStep = 0.5 * kPi;

// The beam from which the ranges, read once around, come first in lexicographic order. Beams that
// compare equal all around are as good as each other: the scan looks the same from each of them.
std::size_t least_rotation(const LaserScan& scan) {
  const std::size_t beams = scan.size();
  const auto key = [&](std::size_t i) {
    const std::size_t beam = i < beams ? i : i - beams;
    return scan.valid(beam) ? scan.ranges[beam] : -1.0;
  };
  std::size_t best = 0;
  std::size_t other = 1;
  std::size_t same = 0;  // so many ranges from `best` and from `other` on agree
  while (best < beams && other < beams && same < beams) {
    const double a = key(best + same);
    const double b = key(other + same);
    if (a == b) {
      ++same;
      continue;
    }
    (a > b ? best : other) += same + 1;
    if (best == other) ++other;
    same = 0;
  }
  return std::min(best, other);
}

}  // namespace

void ScanTrace::assign(const LaserScan& scan, double max_gap) {
  directions_.assign(0.0, scan.angle_increment, scan.size());
  collect(scan, scan.closed ? least_rotation(scan) : 0);
  cut(scan, max_gap);
}

void ScanTrace::collect(const LaserScan& scan, std::size_t start) {
  for (auto* values : {&bearing, &range, &x, &y}) values->clear();
  beam.clear();
  start_bearing_ = scan.bearing(start);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const std::size_t at = start + i < scan.size() ? start + i : start + i - scan.size();
    if (!scan.valid(at)) continue;
    beam.push_back(at);
    bearing.push_back(static_cast<double>(i) * scan.angle_increment);
    range.push_back(scan.ranges[at]);
    x.push_back(scan.ranges[at] * directions_[i].x());
    y.push_back(scan.ranges[at] * directions_[i].y());
  }
}

void ScanTrace::cut(const LaserScan& scan, double max_gap) {
  pieces_.clear();
  const std::size_t points = size();
  if (points == 0) return;
  const double turn = static_cast<double>(scan.size()) * scan.angle_increment;
  const auto gap_before = [&](std::size_t i) {
    const std::size_t previous = i == 0 ? points - 1 : i - 1;
    const double turned = bearing[i] - bearing[previous] + (i == 0 ? turn : 0.0);
    return turned > kWidestStep || !(std::hypot(x[i] - x[previous], y[i] - y[previous]) <= max_gap);
  };
  std::size_t first_gap = 0;
  if (scan.closed) {
    while (first_gap < points && !gap_before(first_gap)) ++first_gap;
    if (first_gap == points) return close_loop(scan);
    // What stands before the first gap continues the last piece.
    const auto middle = static_cast<std::ptrdiff_t>(first_gap);
    for (std::size_t i = 0; i < first_gap; ++i) {
      bearing[i] += turn;
    }
    std::rotate(beam.begin(), beam.begin() + middle, beam.end());
    for (auto* values : {&bearing, &range, &x, &y}) {
      std::rotate(values->begin(), values->begin() + middle, values->end());
    }
  }
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= points; ++i) {
    if (i < points && !gap_before(i)) continue;
    const bool bounded = scan.closed && points > 1;
    const Neighbor before{bounded || begin > 0, range[begin > 0 ? begin - 1 : points - 1]};
    const Neighbor after{bounded || i < points, range[i < points ? i : 0]};
    pieces_.push_back({begin, i, begin, i, before, after});
    begin = i;
  }
}

// Half of the points before the first one, all, and half of them after the last one.
void ScanTrace::close_loop(const LaserScan& scan) {
  const std::size_t points = size();
  const std::size_t half = points / 2;
  const double turn = static_cast<double>(scan.size()) * scan.angle_increment;
  const auto continue_both_ways = [&](auto& values) {
    values.resize(points + 2 * half);
    const auto begin = values.begin();
    const auto whole = static_cast<std::ptrdiff_t>(points);
    const auto part = static_cast<std::ptrdiff_t>(half);
    std::copy(begin, begin + part, begin + whole + part);
    std::copy_backward(begin, begin + whole, begin + whole + part);
    std::copy(begin + whole, begin + whole + part, begin);
  };
  continue_both_ways(beam);
  for (auto* values : {&bearing, &range, &x, &y}) continue_both_ways(*values);
  for (std::size_t i = 0; i < half; ++i) {
    bearing[i] -= turn;
    bearing[half + points + i] += turn;
  }
  pieces_.push_back({0, points + 2 * half, half, half + points, {false, 0.0}, {false, 0.0}});
}

}  // namespace falko_slam
