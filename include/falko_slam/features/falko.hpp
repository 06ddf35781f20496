// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/features/neighborhood_params.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct FalkoParams {
  NeighborhoodParams neighborhood;
  /// beta: base and height of the corner's triangle must reach radius / beta. Greater values admit
  /// wider and sharper corners. [1, 100]
  double triangle_ratio = 4.0;
  /// s_n: sectors of the polar grid of the score. [4, 1024]
  int sectors = 16;
  /// Of keypoints nearer to each other than this only the best one stays. [m]
  double suppression_radius = 0.20;
  /// Sub-beam corners farther than this from their beam's point are refused. [m]
  double refinement_limit = 0.20;
  /// A keypoint is the mean of the corners found within this distance of the best one, weighted by
  /// the inverse of their squared roughness; 0: the best one alone. At most half of
  /// suppression_radius. [m]
  double merge_radius = 0.10;
  /// What is smallest at a keypoint.
  enum class Ranking {
    kRoughness,    ///< residual of the two sides over the height of the corner
    kSectorScore,  ///< Eq. (3.10), as in the thesis
  };
  Ranking ranking = Ranking::kRoughness;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const FalkoParams& params);

/// The parameters that come nearest to the text of \cite kallasi2017: every beam as it was
/// measured, ranked by sector score, no merging.
FalkoParams thesis_falko_params();

/// FALKO: corners of a scan as points where two straight sides meet (\cite kallasi2017 3.1).
///
/// For every beam: neighbourhood of radius a exp(b range), its two sides C_L and C_R (3.1)-(3.2),
/// the triangle test on their far ends (3.3)-(3.4), the sector score (3.5)-(3.10), the sub-beam
/// corner where the lines through the two sides meet (3.1.2), its orientation (3.2.3); then greedy
/// non-maximum suppression, best first.
///
/// All geometry is computed in the frame of the beam itself. Turning the ranges of a closed scan by
/// k beams therefore turns the keypoints with them, exactly; neighbourhoods reach over the seam.
///
/// Deviation: `doc/decisions/0003-falko-departures.md` gives the reasons for sampling and smoothing
/// the neighbourhood, for leaving out grazing beams, for ranking by roughness, for suppressing
/// between the refined corners and for merging; `falko evaluate features` compares them.
///
/// Cost grows linearly with the number of beams. Not thread-safe: one detector for each thread; it
/// keeps its memory, so that detecting allocates nothing in steady state.
class FalkoDetector {
 public:
  explicit FalkoDetector(const FalkoParams& params = {});
  ~FalkoDetector();
  FalkoDetector(FalkoDetector&&) noexcept;
  FalkoDetector& operator=(FalkoDetector&&) noexcept;

  /// Replaces `keypoints` by those of the scan, in the order of their beams.
  void detect(const LaserScan& scan, std::vector<Keypoint>& keypoints);
  std::vector<Keypoint> detect(const LaserScan& scan);

  const FalkoParams& params() const { return params_; }

 private:
  struct Workspace;
  FalkoParams params_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace falko_slam
