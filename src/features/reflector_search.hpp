// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "bright_run.hpp"
#include "falko_slam/features/reflector_detector.hpp"

namespace falko_slam {

/// Ranges of neighbouring beams on one reflector differ by less [m].
double reflector_step(const ReflectorDetectorParams& params);

/// Things that reach over more beams than this are no reflectors, however they are smeared.
bool may_be_reflector(const LaserScan& scan, const BeamRun& run,
                      const ReflectorDetectorParams& params);

/// Judges runs of bright beams one by one: reflectors are added to `found`, what is none is counted
/// in the report, what has no beam above the threshold is neither.
class ReflectorSearch {
 public:
  ReflectorSearch(const LaserScan& scan, const ReflectorDetectorParams& params,
                  std::vector<BrightBeam>& beams, ReflectorReport& report,
                  std::vector<DetectedReflector>& found)
      : scan_(scan), params_(params), beams_(beams), report_(report), found_(found) {}

  /// `edge`: for each beam of the scan what its intensity exceeds on a reflector.
  void judge(const BeamRun& run, const std::vector<float>& edge);

 private:
  void judge_part(std::size_t begin, std::size_t count);
  bool split(std::size_t begin, std::size_t count);
  void refuse(ReflectorRefusal why) { ++report_.refused[static_cast<std::size_t>(why)]; }
  bool hides(std::ptrdiff_t beam, std::ptrdiff_t direction, double range) const;
  void add_reflector(std::size_t begin, std::size_t count, const BrightProfile& profile);

  const LaserScan& scan_;
  const ReflectorDetectorParams& params_;
  std::vector<BrightBeam>& beams_;  // of the run
  ReflectorReport& report_;
  std::vector<DetectedReflector>& found_;
  std::size_t first_ = 0;  // beam of the run
};

}  // namespace falko_slam
