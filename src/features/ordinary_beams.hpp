// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "bright_run.hpp"
#include "falko_slam/features/reflector_detector.hpp"
#include "ordinary_intensity.hpp"

namespace falko_slam {

/// Which beams tell how bright ordinary surfaces are, from scan to scan.
class OrdinaryBeams {
 public:
  /// Takes in a scan but for what may be a reflector: things as narrow as one, and what is as
  /// narrow as one and stands out of its surroundings.
  void learn(const LaserScan& scan, const ReflectorDetectorParams& params);

  /// Of the same scan, what has turned out not to be one.
  void learn_all_but(const LaserScan& scan, const std::vector<DetectedReflector>& reflectors);

  /// What ordinary surfaces at this range reach; 0 unless anything is known.
  float brightest(double range) const { return intensity_.at(range); }
  bool known() const { return brightest(1.0) > 0.0F; }

 private:
  void count(std::size_t beam, bool as_ordinary);
  void leave_out(const LaserScan& scan, const ReflectorDetectorParams& params);

  OrdinaryIntensity intensity_;
  std::vector<OrdinaryIntensity::Cell> cells_;  // of the beams of the scan
  std::vector<char> counted_;                   // those that are among the ordinary ones
  std::vector<BeamRun> runs_;
};

}  // namespace falko_slam
