// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "falko_slam/features/keypoint.hpp"
#include "falko_slam/sensor/laser_scan.hpp"

namespace falko_slam {

struct FlirtParams {
  /// What is looked at over scales.
  enum class Signal {
    kCurvature,  ///< the contour, as a curve over its length
    kRange,      ///< the ranges, over their bearings
  };
  Signal signal = Signal::kCurvature;
  /// Number of scales; more of them find greater shapes. [1, 16]
  int scales = 5;
  /// Standard deviation of the smoothing at the finest scale. Of the range signal it is at least
  /// the angle between two beams. [m] along the contour, [0.01, 10]; [rad] for kRange, [1e-4, 1]
  double base_sigma = 0.20;
  /// Ratio of a scale to the one before. [1.01, 4]
  double sigma_step = 1.4;
  /// Response that a keypoint must reach: of the contour without dimension (1.13 at a right angle,
  /// 0.12 at one of 171 degrees), of the ranges in [m]. Greater values give fewer keypoints.
  /// [0, 100]
  double min_peak = 0.12;
  /// And by which it must exceed that of both neighbours, same unit. [0, 100]
  double min_difference = 0.001;
  /// Half of the window, across the beams, in which the contour is averaged before it is measured;
  /// 0: the points as they are. Unused for kRange. [m], [0, 10]
  double noise_window = 0.05;
  /// Consecutive points farther apart than this are of two surfaces. [m], [0.01, 1000]
  double max_gap = 1.0;
  /// The end of a surface is a keypoint if what follows beyond the gap is farther from the laser.
  /// Unused for kRange, which finds them by itself.
  bool edges = true;
  /// Of keypoints nearer to each other than this only the strongest one stays. [m]
  double suppression_radius = 0.20;
};
/// Throws std::invalid_argument with the field and its value.
void validate(const FlirtParams& params);

/// The defaults of the range signal: three scales from a third of a degree on, jumps of about
/// 0.2 m, no gaps.
FlirtParams flirt_range_params();

/// FLIRT: keypoints of a scan as extrema of a signal over beams and scales
/// (\cite tipaldi2010flirt, \cite unnikrishnan2008).
///
/// Curvature. The contour x(s) is smoothed by Gaussians over its own length s. The response at
/// scale sigma,
///
///     t(s; sigma) = 2 |A(s; sigma) - x(s)| / sigma,   A = G_sigma * x,
///
/// has no dimension: it tells the angle of a corner, not its size. Keypoints are its maxima over
/// beams and scales. Orientation: from x to A, the bisector into the corner, at the end of a
/// surface along it. `Keypoint::radius` is 2 sigma.
///
/// Range. The ranges are smoothed over the bearing; the response sigma^2 d^2 r / d theta^2, as a
/// difference of two scales, is greatest at the nearer side of a jump. The keypoint is the sharpest
/// bend of the unsmoothed ranges within sigma of it. Orientation: normal of the points within
/// 0.3 m on the same surface, towards the laser. `Keypoint::radius` is 2 sigma range, at least
/// suppression_radius.
///
/// `Keypoint::score` is the inverse of the response, `Keypoint::roughness` is not measured: 0.
///
/// Deviation: doc/decisions/0008-flirt-departures.md gives the reasons for measuring length along
/// the chain of beams instead of in a graph of all points, for t instead of t exp(-t), for
/// averaging the points before, for the ends of surfaces, and for suppression over all scales.
///
/// Does not depend on where a closed scan starts. Cost grows linearly with the number of beams,
/// whatever the scales. Not thread-safe; keeps its memory between scans.
class FlirtDetector {
 public:
  explicit FlirtDetector(const FlirtParams& params = {});
  ~FlirtDetector();
  FlirtDetector(FlirtDetector&&) noexcept;
  FlirtDetector& operator=(FlirtDetector&&) noexcept;

  /// Replaces `keypoints` by those of the scan, in the order of their beams.
  void detect(const LaserScan& scan, std::vector<Keypoint>& keypoints);
  std::vector<Keypoint> detect(const LaserScan& scan);

  const FlirtParams& params() const { return params_; }

 private:
  struct Workspace;
  FlirtParams params_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace falko_slam
