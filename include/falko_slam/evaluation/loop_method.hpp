// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "falko_slam/evaluation/loop_protocol.hpp"

namespace falko_slam {

/// Wall time on this machine, in this run, for each scan [ms].
struct LoopTiming {
  double mean = 0.0;
  double median = 0.0;
  double p99 = 0.0;
};
LoopTiming loop_timing(std::vector<double> milliseconds);

template <class Work>
double milliseconds_of(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

/// The scan that another one is closed with.
struct LoopClosure {
  std::size_t target = 0;
  double score = 0.0;  ///< the greater the surer
  Pose2 target_T_source;
};

/// What a method said of one scan.
struct LoopTrial {
  std::optional<LoopClosure> closure;
  std::optional<double> search;  ///< share of the time until the candidates were found [ms]
};

/// A way to close loops between the scans of a log, which it has seen already.
struct LoopMethod {
  std::string name;
  std::optional<LoopTiming> detection;  ///< keypoints and their descriptors, if timed apart
  LoopTiming creation;                  ///< of the signature; with the keypoints if not timed apart
  std::function<LoopTrial(std::size_t source, const LoopTruth& truth)> close;
};

/// One method under one protocol.
struct LoopMethodResult {
  std::string method;
  LoopProtocol protocol = LoopProtocol::kOffline;
  std::size_t scans = 0;
  std::size_t loops = 0;
  LoopSummary summary;
  /// What our detector accepts by itself; no other method does.
  std::optional<LoopOperatingPoint> accepted;
  std::size_t ambiguous = 0;  ///< scans whose best loop it refused as ambiguous
  std::vector<LoopOperatingPoint> curve;
  /// Table 4.1 of \cite kallasi2017. `closing` is the whole answer; search and association are its
  /// parts, where a method has these.
  std::optional<LoopTiming> detection;
  LoopTiming creation;
  std::optional<LoopTiming> search;
  std::optional<LoopTiming> association;
  LoopTiming closing;
};

/// The answers to all scans, in `answers`, and their measures.
LoopMethodResult run_method(const LoopMethod& method, const LoopTruth& truth,
                            std::vector<LoopAnswer>& answers);

}  // namespace falko_slam
