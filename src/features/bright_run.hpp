// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// Beams side by side; on a closed scan they may reach over its seam.
struct BeamRun {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// All runs of beams that belong to each other, whole ones only: where a closed scan begins within
/// one, it is found at its end. `joined(i, j)`: whether neighbour j belongs to i; `member(i)`.
template <class Member, class Joined>
void find_runs(const LaserScan& scan, Member member, Joined joined, std::vector<BeamRun>& runs) {
  const std::size_t beams = scan.size();
  runs.clear();
  const auto linked = [&](std::size_t i) {  // to the one before
    if (i == 0 && (!scan.closed || beams < 2)) return false;
    const std::size_t before = i == 0 ? beams - 1 : i - 1;
    return member(before) && member(i) && joined(before, i);
  };
  for (std::size_t i = 0; i < beams; ++i) {
    if (!member(i) || linked(i)) continue;
    std::size_t count = 1;
    while (count < beams && (scan.closed || i + count < beams) && linked((i + count) % beams)) {
      ++count;
    }
    runs.push_back({i, count});
  }
}

/// A beam on a reflector.
struct BrightBeam {
  double excess = 0.0;  ///< of its intensity above that of ordinary surfaces
  double range = 0.0;   ///< [m]; NaN: a single beam without an echo between others
  float edge = 0.0F;    ///< what ordinary surfaces reach
};

/// How bright beams lie side by side.
struct BrightProfile {
  double peak = 0.0;        ///< greatest excess
  double sum = 0.0;         ///< of the excess
  double middle = 0.0;      ///< mean beam, weighted by excess, counted from the first one
  double range = 0.0;       ///< mean, weighted by excess [m]
  double half_begin = 0.0;  ///< where the excess reaches half its peak, in beams from the first one
  double half_end = 0.0;

  double half_width() const { return half_end - half_begin; }  ///< [beams]
};

/// `count` of the beams from `first` on; at least one has a range and an excess.
BrightProfile profile_of(const BrightBeam* first, std::size_t count);

/// Where two bright things meet: the beam between two others that reach `depth` times its excess,
/// or `count` if there is none.
std::size_t valley_of(const BrightBeam* first, std::size_t count, double depth);

}  // namespace falko_slam
