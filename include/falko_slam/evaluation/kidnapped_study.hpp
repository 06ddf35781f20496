// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "falko_slam/evaluation/detector_run.hpp"

namespace falko_slam {

struct KidnappedParams {
  LoopProtocolParams protocol;
  std::size_t hypotheses = 5;  ///< asked for from one scan. At least 1
};

/// Where is a robot that knows nothing, on a map of all other places of its way? *Visited* are the
/// scans of a place that was seen at another time too: within loop_distance and loop_turn of one at
/// least min_path of way earlier or later (LoopProtocol::kKidnapped).
struct KidnappedResult {
  std::size_t scans = 0;
  std::size_t visited = 0;
  /// From one scan alone, of the visited: the share whose best hypothesis is right, and the share
  /// with a right one among all.
  double best_right = 0.0;
  double any_right = 0.0;
  LoopSummary best;     ///< if the best hypothesis were accepted by its score
  LoopTiming locating;  ///< one scan
  /// With the keyframes of the last metres behind it: what the detector closes and accepts.
  LoopMethodResult travelled;
};

/// The scans of the run, placed one by one on all other places of its way.
/// Throws std::invalid_argument if `scans` are not those of the run, or no hypothesis is asked for.
KidnappedResult study_kidnapped(const std::vector<PosedScan>& scans, DetectorRun& run,
                                const KidnappedParams& params = {});

}  // namespace falko_slam
