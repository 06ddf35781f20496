// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

/// The grid has the values of the authors' implementation of \cite tipaldi2010flirt.
struct BetaGridParams {
  double min_radius = 0.02;  ///< where the innermost ring begins [m]. [0.001, radius / 2]
  double radius = 0.5;       ///< where the outermost ring ends [m]. [0.05, 10]
  int rings = 4;             ///< of equal width. [1, 64]
  int sectors = 12;          ///< counter-clockwise from the keypoint's orientation. [2, 256]
  /// Beams that are so far apart at the keypoint count as one hit or miss each, denser ones less.
  /// Smaller values believe the beams more. [m], [0.001, 10]
  double evidence_length = 0.10;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const BetaGridParams& params);

/// What is known of the cells of a polar grid around a keypoint, turned to its orientation
/// (\cite tipaldi2010flirt): cell (ring m, sector j) stands at m * sectors + j.
///
/// A cell in which h beams end and through which m beams pass is occupied with a probability that
/// is distributed as Beta(a, b), a = 1 + w h, b = 1 + w m: a uniform prior, so that a cell nobody
/// saw has 1/2.
///
/// Deviation: a beam counts w = range * angle_increment / evidence_length, its share of the
/// surface, instead of 1. The descriptor then depends neither on the resolution of the scanner nor
/// on the distance of the keypoint (doc/decisions/0008-flirt-departures.md).
struct BetaGrid {
  std::vector<float> occupancy;  ///< a / (a + b)
  std::vector<float> variance;   ///< a b / ((a + b)^2 (a + b + 1))
};

/// Symmetric chi-square distance of the occupancies p and q, a cell weighing the more the better it
/// is known:
///
///     sum_i w_i (p_i - q_i)^2 / (p_i + q_i) / sum_i w_i,   w_i = 1 / (var p_i + var q_i),
///
/// in [0, 1). Throws std::invalid_argument if the grids differ in size.
double distance(const BetaGrid& a, const BetaGrid& b);

/// The beta-grids of keypoints of any detector.
///
/// Each valid beam is followed through the grid from the laser to its point: it counts once as a
/// hit for the cell its point lies in, and once as a miss for each other cell that it crosses.
/// Invalid beams tell nothing. Only beams that come within the radius are looked at.
/// Keeps its memory between scans; not thread-safe.
class BetaGridExtractor {
 public:
  explicit BetaGridExtractor(const BetaGridParams& params = {});
  ~BetaGridExtractor();
  BetaGridExtractor(BetaGridExtractor&&) noexcept;
  BetaGridExtractor& operator=(BetaGridExtractor&&) noexcept;

  /// Replaces `grids` by those of the keypoints, in the same order.
  void extract(const LaserScan& scan, const std::vector<Keypoint>& keypoints,
               std::vector<BetaGrid>& grids);
  std::vector<BetaGrid> extract(const LaserScan& scan, const std::vector<Keypoint>& keypoints);

  const BetaGridParams& params() const { return params_; }

 private:
  struct Workspace;
  BetaGridParams params_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace falko_slam
