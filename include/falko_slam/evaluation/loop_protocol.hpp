// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "falko_slam/evaluation/posed_scan.hpp"

namespace falko_slam {

/// Which scans a scan may be closed with (\cite kallasi2017, section 4.2.1).
enum class LoopProtocol {
  kOffline,   ///< all others
  kOnline,    ///< earlier ones, not at the same place: another x, y or heading by the thresholds
  kRevisits,  ///< earlier ones at least `min_path` of way back
  /// Earlier and later ones at least `min_path` of way off: a robot that does not know where it is,
  /// with a map of everywhere else on its way. Not of the thesis.
  kKidnapped,
};
const char* name_of(LoopProtocol protocol);

struct LoopProtocolParams {
  double min_step = 0.20;             ///< x_th and y_th [m]
  double min_turn = 0.35;             ///< theta_th [rad]
  double min_path = 10.0;             ///< of kRevisits and kKidnapped [m]
  double loop_distance = 1.0;         ///< a scan has a loop if one that it may be closed with is
  double loop_turn = 0.785398163397;  ///< within this distance [m] and turn [rad]
  double max_error = 0.50;            ///< of a right closure [m]
  double max_turn_error = 0.174532925199;  ///< [rad]
};

/// The truth about a log, under one protocol.
class LoopTruth {
 public:
  LoopTruth(const std::vector<PosedScan>& scans, LoopProtocol protocol,
            const LoopProtocolParams& params = {});

  bool admits(std::size_t source, std::size_t target) const;
  bool has_loop(std::size_t source) const { return has_loop_[source]; }
  bool is_right(std::size_t source, std::size_t target, const Pose2& target_T_source) const;
  std::size_t loops() const;
  std::size_t scans() const { return poses_.size(); }
  LoopProtocol protocol() const { return protocol_; }

 private:
  std::vector<Pose2> poses_;
  std::vector<double> paths_;
  LoopProtocol protocol_;
  LoopProtocolParams params_;
  std::vector<bool> has_loop_;
};

/// What a method said of one scan.
struct LoopAnswer {
  bool closed = false;
  double score = 0.0;     ///< the greater the surer
  bool right = false;     ///< its pose is
  bool has_loop = false;  ///< there was one to be found
};

/// Closures with at least this score: how many of them are right, and the share of scans with a
/// loop that are closed rightly. A closure of a scan without a loop is right if its pose is.
struct LoopOperatingPoint {
  double min_score = 0.0;
  double precision = 1.0;
  double recall = 0.0;
  std::size_t closures = 0;
  std::size_t wrong = 0;
};
LoopOperatingPoint operating_point(const std::vector<LoopAnswer>& answers, double min_score);

/// A point for every score that occurs, the greatest first (\cite kallasi2017, Fig. 4.2).
std::vector<LoopOperatingPoint> loop_curve(const std::vector<LoopAnswer>& answers);

/// The measures of a curve.
struct LoopSummary {
  double break_even = 0.0;     ///< recall where precision falls to it; 0 if it never does so
  double recall_at_100 = 0.0;  ///< greatest recall at a precision of 1
  double recall_at_95 = 0.0;   ///< and of at least .95
  double f1 = 0.0;             ///< greatest harmonic mean of both
};
LoopSummary summarize(const std::vector<LoopOperatingPoint>& curve);

}  // namespace falko_slam
