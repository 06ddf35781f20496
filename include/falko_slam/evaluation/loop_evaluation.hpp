// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/loop_protocol.hpp"
#include "falko_slam/place_recognition/loop_detector.hpp"

namespace falko_slam {

struct LoopEvaluationParams {
  std::vector<LoopProtocol> protocols = {LoopProtocol::kOffline, LoopProtocol::kOnline,
                                         LoopProtocol::kRevisits};
  LoopProtocolParams protocol;
  LoopDetectorParams detector;
  int candidates = 10;             ///< of the thesis' methods
  double neighbor_distance = 0.1;  ///< keypoints that are nearer after alignment count [m]
  std::uint64_t seed = 1;          ///< of RANSAC
};

struct LoopTiming {
  double mean = 0.0;    ///< [ms]
  double median = 0.0;  ///< [ms]
  double p99 = 0.0;     ///< [ms]
};

/// One method under one protocol.
struct LoopMethodResult {
  std::string method;
  LoopProtocol protocol = LoopProtocol::kOffline;
  std::size_t scans = 0;
  std::size_t loops = 0;
  LoopSummary summary;
  LoopOperatingPoint accepted;  ///< what our detector accepts by itself; of no other method
  std::size_t ambiguous = 0;    ///< scans whose best loop it refused as ambiguous
  std::vector<LoopOperatingPoint> curve;
  LoopTiming creation;  ///< keypoints and signature
  LoopTiming closing;   ///< search, association and verification of one scan
};

/// Fig. 4.2 and Table 4.1 of \cite kallasi2017 for one log: GLAROT signatures of FALKO keypoints
/// with correspondence graph, affine Hough transform and RANSAC, and our loop detector.
///
/// Of the thesis' methods the candidate wins after whose alignment the most keypoints have a
/// neighbour; their number is the score. `tell` hears what is worked on.
std::vector<LoopMethodResult> evaluate_loops(const std::vector<PosedScan>& scans,
                                             const LoopEvaluationParams& params,
                                             const std::function<void(const std::string&)>& tell);

}  // namespace falko_slam
